#include "spectrum/wavelength_importance.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include <fmt/core.h>

namespace emulsion {

namespace {

double response(const Observer& observer, double lambda_nm) noexcept {
    const XYZd xyz = eval(observer, lambda_nm);
    return xyz.x + xyz.y + xyz.z;
}

// Integral over [from_nm, to_nm], where the spectrum has no knots and the observer is a straight line: Simpson's rule,
// exact for straight lines, and near enough for the smooth ones. The limits are those from inside.
double smooth_integral(const Spectrum& spectrum, const Observer& observer, double from_nm, double to_nm) {
    constexpr int kPanels = 4;
    const double step_nm = (to_nm - from_nm) / kPanels;
    double sum = 0.0;
    for (int i = 0; i < kPanels; ++i) {
        const double a_nm = from_nm + i * step_nm;
        const double b_nm = i + 1 == kPanels ? to_nm : a_nm + step_nm;
        const double middle_nm = 0.5 * (a_nm + b_nm);
        sum += (b_nm - a_nm) / 6.0 *
               (limit(spectrum, a_nm, Side::above) * response(observer, a_nm) +
                4.0 * eval(spectrum, middle_nm) * response(observer, middle_nm) +
                limit(spectrum, b_nm, Side::below) * response(observer, b_nm));
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
    const std::vector<double> knots = knots_nm(light);
    for (std::size_t cell = 0; cell < kWavelengthCells; ++cell) {
        const double end_nm = kMinWavelength_nm + static_cast<double>(cell) + 1.0;
        double from_nm = end_nm - 1.0;
        for (auto knot = std::upper_bound(knots.begin(), knots.end(), from_nm); knot != knots.end() && *knot < end_nm;
             ++knot) {
            importance.per_nm[cell] += std::abs(smooth_integral(light, observer, from_nm, *knot));
            from_nm = *knot;
        }
        importance.per_nm[cell] += std::abs(smooth_integral(light, observer, from_nm, end_nm));
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
