#include "spectrum/wavelength_importance.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>

#include <fmt/core.h>

#include "spectrum/integral.h"
#include "spectrum/integral_panels.h"

namespace emulsion {

namespace {

double response(const Observer& observer, double lambda_nm) noexcept {
    const XYZd xyz = eval(observer, lambda_nm);
    return xyz.x + xyz.y + xyz.z;
}

// Integral of the continuum's magnitude over the cell that starts at the first cut and ends at the last, between which
// are its knots. Of each stretch between two cuts, so that what changes its sign at a knot isn't cancelled.
double importance_of_cell(const Spectrum& light, const Observer& observer, std::span<const double> cuts_nm) {
    std::optional<int> degree = polynomial_degree(light);
    if (degree) ++*degree;
    const auto integrand = [&](const OffsetWavelengths& at, std::span<Sums<1>> values) {
        WavelengthBlock power{};
        eval(light, at, std::span(power).first(at.size()));
        for (std::size_t i = 0; i < at.size(); ++i) values[i][0] = power[i] * response(observer, at[i]);
    };
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < cuts_nm.size(); ++i) {
        sum += std::abs(integral_over_cuts<1>(cuts_nm.subspan(i, 2), degree, integrand)[0]);
    }
    return sum;
}

[[noreturn]] void refuse(const std::string& field, double value, const std::string& range) {
    throw std::invalid_argument(fmt::format("{} is {}: expected {}", field, value, range));
}

void check_place(double lambda_nm, std::size_t i) {
    if (lambda_nm >= kMinWavelength_nm && lambda_nm <= kMaxWavelength_nm) return;
    refuse(fmt::format("line {}: lambda_nm", i), lambda_nm,
           fmt::format("a wavelength in [{}, {}]", kMinWavelength_nm, kMaxWavelength_nm));
}

bool can_be_seen(const Line& line) noexcept {
    return line.lambda_nm >= kMinWavelength_nm && line.lambda_nm <= kMaxWavelength_nm;
}

}  // namespace

WavelengthImportance wavelength_importance(const Spectrum& light, const Observer& observer) {
    validate(light);
    WavelengthImportance importance;
    const std::vector<double> inner_cuts = integration_cuts_nm(light, kMinWavelength_nm, kMaxWavelength_nm);
    std::vector<double> cuts;
    for (std::size_t cell = 0; cell < kWavelengthCells; ++cell) {
        const double start_nm = kMinWavelength_nm + static_cast<double>(cell), end_nm = start_nm + 1.0;
        const auto first = std::upper_bound(inner_cuts.begin(), inner_cuts.end(), start_nm);
        cuts.assign({start_nm});
        cuts.insert(cuts.end(), first, std::lower_bound(first, inner_cuts.end(), end_nm));
        cuts.push_back(end_nm);
        importance.per_nm[cell] = importance_of_cell(light, observer, cuts);
    }
    for (const Line& line : delta_lines(light)) {
        if (!can_be_seen(line)) continue;
        importance.lines.push_back({line.lambda_nm, std::abs(line.power) * response(observer, line.lambda_nm)});
    }
    return importance;
}

std::vector<double> line_powers(const Spectrum& light, const WavelengthImportance& importance) {
    validate(light);
    std::vector<double> powers(importance.lines.size(), 0.0);
    for (const Line& line : delta_lines(light)) {
        if (!can_be_seen(line)) continue;
        const auto found = std::find_if(importance.lines.begin(), importance.lines.end(),
                                        [&](const LineImportance& known) { return known.lambda_nm == line.lambda_nm; });
        if (found == importance.lines.end()) {
            refuse("line of the light: lambda_nm", line.lambda_nm,
                   "one of the lines that the wavelengths are drawn from");
        }
        powers[static_cast<std::size_t>(found - importance.lines.begin())] = line.power;
    }
    return powers;
}

void validate(const WavelengthImportance& importance) {
    const auto good = [](double value) { return std::isfinite(value) && value >= 0.0; };
    for (std::size_t i = 0; i < kWavelengthCells; ++i) {
        if (good(importance.per_nm[i])) continue;
        refuse(fmt::format("importance: per_nm[{}]", i), importance.per_nm[i], "a finite number >= 0");
    }
    for (std::size_t i = 0; i < importance.lines.size(); ++i) {
        check_place(importance.lines[i].lambda_nm, i);
        const double value = importance.lines[i].importance;
        if (!good(value)) refuse(fmt::format("line {}: importance", i), value, "a finite number >= 0");
    }
    if (importance.lines.size() > kMaxWavelengthLines) {
        refuse("importance: the number of lines", static_cast<double>(importance.lines.size()),
               fmt::format("at most {}", kMaxWavelengthLines));
    }
    double sum = std::accumulate(importance.per_nm.begin(), importance.per_nm.end(), 0.0);
    for (const LineImportance& line : importance.lines) sum += line.importance;
    if (!(sum > 0.0 && std::isfinite(sum))) refuse("importance: the sum", sum, "a finite number > 0");
}

}  // namespace emulsion
