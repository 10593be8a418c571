#include "spectrum/spectrum_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>

#include <fmt/core.h>

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

CellMoments moments_of(const Spectrum& spectrum, double first_nm, std::span<const double> inner_knots_nm) {
    CellMoments moments;
    double from_nm = first_nm;
    for (std::size_t piece = 0; piece <= inner_knots_nm.size(); ++piece) {
        const double to_nm = piece < inner_knots_nm.size() ? inner_knots_nm[piece] : first_nm + 1.0;
        const double middle_nm = 0.5 * (from_nm + to_nm);
        // Simpson's rule: exact for two straight lines, and so for each of the integrals.
        const auto add = [&](double weight, double lambda_nm, double value) {
            const double share = weight / 6.0 * (to_nm - from_nm), ybar = eval(cie_1931_2deg(), lambda_nm).y;
            moments.mean += share * value;
            moments.first += share * value * (lambda_nm - first_nm - 0.5);
            moments.luminance += share * value * ybar;
            moments.observer += share * ybar;
            moments.least = std::min(moments.least, value);
            moments.greatest = std::max(moments.greatest, value);
        };
        add(1.0, from_nm, limit(spectrum, from_nm, Side::above));
        add(4.0, middle_nm, eval(spectrum, middle_nm));
        add(1.0, to_nm, limit(spectrum, to_nm, Side::below));
        from_nm = to_nm;
    }
    return moments;
}

/// The line for a cell that has knots inside.
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

}  // namespace

SpectrumTable::SpectrumTable(const Spectrum& spectrum, double scale) {
    validate(spectrum);
    const std::vector<double> knots = knots_nm(spectrum);
    lines_.reserve(kMaxWavelength_nm - kMinWavelength_nm);
    for (int lambda_nm = kMinWavelength_nm; lambda_nm < kMaxWavelength_nm; ++lambda_nm) {
        // Limits from inside the cell, so that a jump at a whole nanometre stays a jump.
        CellLine line = {limit(spectrum, lambda_nm, Side::above), limit(spectrum, lambda_nm + 1, Side::below)};
        const auto first = std::upper_bound(knots.begin(), knots.end(), lambda_nm);
        const auto last = std::lower_bound(first, knots.end(), lambda_nm + 1);
        if (first != last) line = fitted_line(moments_of(spectrum, lambda_nm, {first, last}));

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
