#include "film/filter_mitchell.h"

#include <cmath>

namespace emulsion {

namespace {

double cubic(double b, double c, double offset_px, double radius_px) noexcept {
    const double x = std::abs(2.0 * offset_px / radius_px);
    if (x <= 1.0) {
        return ((12.0 - 9.0 * b - 6.0 * c) * x * x * x + (-18.0 + 12.0 * b + 6.0 * c) * x * x + (6.0 - 2.0 * b)) / 6.0;
    }
    return ((-b - 6.0 * c) * x * x * x + (6.0 * b + 30.0 * c) * x * x + (-12.0 * b - 48.0 * c) * x +
            (8.0 * b + 24.0 * c)) /
           6.0;
}

}  // namespace

double eval_inside(const MitchellFilter& filter, double offset_px, double radius_px) noexcept {
    return cubic(static_cast<double>(filter.b), static_cast<double>(filter.c), offset_px, radius_px);
}

double eval_inside(const CatmullRomFilter&, double offset_px, double radius_px) noexcept {
    return cubic(0.0, 0.5, offset_px, radius_px);
}

}  // namespace emulsion
