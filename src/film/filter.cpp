#include "film/filter.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/visit.h"

namespace emulsion {

namespace {

/// Integrals over half of an axis.
struct AxisIntegrals {
    double of_f = 0.0, of_magnitude = 0.0;  ///< of f and of |f|
};

/// By midpoints, at least eight to a pixel up to a radius of 4096: within 1e-4 of the integral of |f| for all filters
/// of moderate shape, and the right sign for those without lobes.
AxisIntegrals coarse_integrals(const Filter& filter, FilterAxis axis) noexcept {
    const double radius = radius_px(filter, axis);
    const int steps = static_cast<int>(std::clamp(8.0 * radius, 256.0, 32768.0));
    AxisIntegrals sums;
    for (int i = 0; i < steps; ++i) {
        const double f = eval(filter, axis, (i + 0.5) * (radius / steps));
        sums.of_f += f;
        sums.of_magnitude += std::abs(f);
    }
    return sums;
}

void require_normalisable(const Filter& filter, FilterAxis axis) {
    const AxisIntegrals integrals = coarse_integrals(filter, axis);
    if (integrals.of_f > 0.0 && integrals.of_f >= kMinIntegral * integrals.of_magnitude) return;
    throw std::invalid_argument(
        "filter " + to_text(filter) + ": the integral along an axis is " +
        (integrals.of_magnitude > 0.0
             ? number_text(static_cast<float>(integrals.of_f / integrals.of_magnitude)) + " of that of its magnitude"
             : "0") +
        ", expected at least 1/1024");
}

}  // namespace

double radius_px(const Filter& filter, FilterAxis axis) noexcept {
    return visit_noexcept(
        [axis](const auto& f) { return static_cast<double>(axis == FilterAxis::x ? f.x_radius_px : f.y_radius_px); },
        filter);
}

double eval(const Filter& filter, FilterAxis axis, double offset_px) noexcept {
    const double radius = radius_px(filter, axis);
    if (!(std::abs(offset_px) < radius)) return 0.0;
    return visit_noexcept([=](const auto& f) { return eval_inside(f, offset_px, radius); }, filter);
}

bool has_negative_lobes(const Filter& filter) noexcept {
    // Where polynomials meet 0, values may round to less: 1e-16 of the greatest.
    constexpr double kRounding = 1e-12;
    const auto is_negative = [&filter](FilterAxis axis) {
        const AxisIntegrals integrals = coarse_integrals(filter, axis);
        return integrals.of_magnitude - integrals.of_f > kRounding * integrals.of_magnitude;
    };
    return is_negative(FilterAxis::x) || is_negative(FilterAxis::y);
}

void validate(const Filter& filter) {
    validate_named(filter, "filter");
    require_normalisable(filter, FilterAxis::x);
    if (radius_px(filter, FilterAxis::y) != radius_px(filter, FilterAxis::x)) {
        require_normalisable(filter, FilterAxis::y);
    }
}

}  // namespace emulsion
