#include "spectrum/spectrum_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>

#include <fmt/core.h>

#include "spectrum/integral.h"
#include "spectrum/integral_panels.h"
#include "spectrum/observer.h"

namespace emulsion {

namespace {

/// A straight line over one cell.
struct CellLine {
    double start, end;
};

/// What a line has to keep of the spectrum in its cell; t from 0 to 1 over the cell.
struct CellMoments {
    double mean = 0.0;                                           // integral S dt
    double first = 0.0;                                          // integral S (t - 1/2) dt
    double luminance = 0.0;                                      // integral S ybar dt
    double observer = 0.0;                                       // integral ybar dt
    double least = std::numeric_limits<double>::infinity();      // of S
    double greatest = -std::numeric_limits<double>::infinity();  // of S
};

/// Integral of ybar over a cell: a straight line.
double observer_integral(double first_nm) {
    return 0.5 * (eval(cie_1931_2deg(), first_nm).y + eval(cie_1931_2deg(), first_nm + 1.0).y);
}

/// Of the continuum; cuts_nm: the ends of the cell and the knots inside.
CellMoments moments_of(const Spectrum& spectrum, std::span<const double> cuts_nm) {
    const double first_nm = cuts_nm.front();
    std::optional<int> degree = polynomial_degree(spectrum);
    if (degree) ++*degree;
    const auto integrand = [&](const OffsetWavelengths& at, std::span<Sums<3>> values) {
        WavelengthBlock spectrum_values{};
        eval(spectrum, at, std::span(spectrum_values).first(at.size()));
        for (std::size_t i = 0; i < at.size(); ++i) {
            const double t = (at.base_nm - first_nm) + at.offset_nm[i];
            values[i] = {spectrum_values[i], spectrum_values[i] * (t - 0.5),
                         spectrum_values[i] * eval(cie_1931_2deg(), at[i]).y};
        }
    };
    CellMoments moments;
    const Sums<3> sums = integral_over_cuts<3>(cuts_nm, degree, integrand);
    moments.mean = sums[0];
    moments.first = sums[1];
    moments.luminance = sums[2];
    moments.observer = observer_integral(first_nm);
    const auto include = [&moments](double value) {
        moments.least = std::min(moments.least, value);
        moments.greatest = std::max(moments.greatest, value);
    };
    for (std::size_t i = 0; i + 1 < cuts_nm.size(); ++i) {
        include(limit(spectrum, cuts_nm[i], Side::above));
        include(eval(spectrum, 0.5 * (cuts_nm[i] + cuts_nm[i + 1])));
        include(limit(spectrum, cuts_nm[i + 1], Side::below));
    }
    return moments;
}

/// Of a line without width, spread over its cell: anything between it and 0 is in range.
CellMoments moments_of(const Line& line, double first_nm) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    CellMoments moments;
    moments.mean = line.power;
    moments.first = line.power * (line.lambda_nm - first_nm - 0.5);
    moments.luminance = line.power * eval(cie_1931_2deg(), line.lambda_nm).y;
    moments.observer = observer_integral(first_nm);
    moments.least = line.power < 0.0 ? -kInfinity : 0.0;
    moments.greatest = line.power > 0.0 ? kInfinity : 0.0;
    return moments;
}

/// The line for a cell in which the spectrum is none.
CellLine fitted_line(const CellMoments& of) {
    const CellLine nearest = {of.mean - 6.0 * of.first, of.mean + 6.0 * of.first};
    // ybar is a straight line too, so that `nearest` keeps the luminance; so does this constant, and what lies between.
    const double constant = of.observer > 0.0 ? std::clamp(of.luminance / of.observer, of.least, of.greatest) : of.mean;
    double share = 1.0;
    for (const double end : {nearest.start, nearest.end}) {
        if (end < of.least) share = std::min(share, (of.least - constant) / (end - constant));
        if (end > of.greatest) share = std::min(share, (of.greatest - constant) / (end - constant));
    }
    const auto pulled = [&](double end) {
        return std::clamp(constant + share * (end - constant), of.least, of.greatest);
    };
    return {pulled(nearest.start), pulled(nearest.end)};
}

/// The last cell has both its ends.
bool is_in_cell(double lambda_nm, int first_nm) noexcept {
    return lambda_nm >= first_nm &&
           (lambda_nm < first_nm + 1 || (first_nm + 1 == kMaxWavelength_nm && lambda_nm == kMaxWavelength_nm));
}

}  // namespace

SpectrumTable::SpectrumTable(const Spectrum& spectrum, double scale) {
    validate(spectrum);
    const std::vector<double> knots = integration_cuts_nm(spectrum, kMinWavelength_nm, kMaxWavelength_nm);
    const bool is_straight = polynomial_degree(spectrum).value_or(2) <= 1;
    const std::vector<Line> delta = delta_lines(spectrum);
    lines_.reserve(kMaxWavelength_nm - kMinWavelength_nm);
    for (int lambda_nm = kMinWavelength_nm; lambda_nm < kMaxWavelength_nm; ++lambda_nm) {
        // Limits from inside the cell, so that a jump at a whole nanometre stays a jump.
        CellLine line = {limit(spectrum, lambda_nm, Side::above), limit(spectrum, lambda_nm + 1, Side::below)};
        const auto first = std::upper_bound(knots.begin(), knots.end(), lambda_nm);
        const auto last = std::lower_bound(first, knots.end(), lambda_nm + 1);
        if (first != last || !is_straight) {
            std::vector<double> cuts = {static_cast<double>(lambda_nm)};
            cuts.insert(cuts.end(), first, last);
            cuts.push_back(lambda_nm + 1);
            line = fitted_line(moments_of(spectrum, cuts));
        }
        for (const Line& narrow : delta) {
            if (!is_in_cell(narrow.lambda_nm, lambda_nm)) continue;
            const CellLine spread = fitted_line(moments_of(narrow, lambda_nm));
            line = {line.start + spread.start, line.end + spread.end};
        }

        const double start = scale * line.start, end = scale * line.end;
        lines_.push_back({static_cast<float>(start), static_cast<float>(end - start)});
        if (!std::isfinite(lines_.back().start) || !std::isfinite(lines_.back().slope)) {
            throw std::invalid_argument(fmt::format(
                "spectrum times {} is {} at {} nm and {} at {} nm: expected finite numbers of single precision", scale,
                start, lambda_nm, end, lambda_nm + 1));
        }
    }
}

}  // namespace emulsion
