#include "film/filter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <string>

#include "core/visit.h"

namespace emulsion {

namespace {

double sinc(double x) noexcept {
    const double pi_x = std::numbers::pi * x;
    // Below, sin(y)/y is 1 - y^2/6: 1 in double precision.
    return std::abs(pi_x) < 1e-8 ? 1.0 : std::sin(pi_x) / pi_x;
}

double gaussian(double x, double sigma) noexcept {
    return std::exp(-x * x / (2.0 * sigma * sigma)) / (sigma * std::sqrt(2.0 * std::numbers::pi));
}

// Weights inside the radius, |offset_px| < radius_px.

double eval_inside(const BoxFilter&, double, double) noexcept { return 1.0; }

double eval_inside(const TriangleFilter&, double offset_px, double radius_px) noexcept {
    return 1.0 - std::abs(offset_px) / radius_px;
}

double eval_inside(const GaussianFilter& filter, double offset_px, double radius_px) noexcept {
    const auto sigma_px = static_cast<double>(filter.sigma_px);
    return std::max(0.0, gaussian(offset_px, sigma_px) - gaussian(radius_px, sigma_px));
}

double eval_inside(const MitchellFilter& filter, double offset_px, double radius_px) noexcept {
    const auto b = static_cast<double>(filter.b), c = static_cast<double>(filter.c);
    const double x = std::abs(2.0 * offset_px / radius_px);
    if (x <= 1.0) {
        return ((12.0 - 9.0 * b - 6.0 * c) * x * x * x + (-18.0 + 12.0 * b + 6.0 * c) * x * x + (6.0 - 2.0 * b)) / 6.0;
    }
    return ((-b - 6.0 * c) * x * x * x + (6.0 * b + 30.0 * c) * x * x + (-12.0 * b - 48.0 * c) * x +
            (8.0 * b + 24.0 * c)) /
           6.0;
}

double eval_inside(const LanczosSincFilter& filter, double offset_px, double) noexcept {
    return sinc(offset_px) * sinc(offset_px / static_cast<double>(filter.tau));
}

void require(bool ok, std::string_view filter, std::string_view field, double value, std::string_view expected) {
    if (ok) return;
    throw std::invalid_argument(std::string(filter) + " filter: " + std::string(field) + " is " +
                                std::to_string(value) + ", expected " + std::string(expected));
}

void require_positive(std::string_view filter, std::string_view field, float value) {
    require(std::isfinite(value) && value > 0.0f, filter, field, static_cast<double>(value), "a finite number > 0");
}

void require_finite(std::string_view filter, std::string_view field, float value) {
    require(std::isfinite(value), filter, field, static_cast<double>(value), "a finite number");
}

void validate_shape(const BoxFilter&) {}
void validate_shape(const TriangleFilter&) {}
void validate_shape(const GaussianFilter& filter) {
    require_positive(GaussianFilter::kName, "sigma_px", filter.sigma_px);
}
void validate_shape(const MitchellFilter& filter) {
    require_finite(MitchellFilter::kName, "b", filter.b);
    require_finite(MitchellFilter::kName, "c", filter.c);
}
void validate_shape(const LanczosSincFilter& filter) { require_positive(LanczosSincFilter::kName, "tau", filter.tau); }

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

void validate(const Filter& filter) {
    std::visit(
        [](const auto& f) {
            require_positive(f.kName, "x_radius_px", f.x_radius_px);
            require_positive(f.kName, "y_radius_px", f.y_radius_px);
            validate_shape(f);
        },
        filter);
}

}  // namespace emulsion
