#include "pathtracer/equal_area.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace emulsion {

namespace {

constexpr double kQuarterTurn = 0.5 * std::numbers::pi;

}  // namespace

Imath::V3d equal_area_direction(const Imath::V2d& place) noexcept {
    const double u = 2.0 * place.x - 1.0, v = 2.0 * place.y - 1.0;
    const double right = std::abs(u), up = std::abs(v);
    // Above 0 inside the square on its tip, and 0 on its edge, the equator.
    const double above = 1.0 - (right + up);
    const double radius = 1.0 - std::abs(above);
    // From 0 on the u axis to 1 on the v axis, in the first quadrant. The poles have no longitude: any will do.
    const double turn = radius > 0.0 ? 0.5 * ((up - right) / radius + 1.0) : 0.5;
    const double phi = kQuarterTurn * turn;
    const double sin_theta = radius * std::sqrt(std::max(2.0 - radius * radius, 0.0));
    return {std::copysign(sin_theta * std::cos(phi), u), std::copysign(sin_theta * std::sin(phi), v),
            std::copysign(1.0 - radius * radius, above)};
}

Imath::V2d equal_area_place(const Imath::V3d& direction) noexcept {
    const double x = std::abs(direction.x), y = std::abs(direction.y), z = std::abs(direction.z);
    // 1 - z without cancellation near the poles.
    const double radius = std::sqrt(std::min((x * x + y * y) / (1.0 + z), 1.0));
    const double turn = std::atan2(y, x) / kQuarterTurn;
    double u = radius * (1.0 - turn), v = radius * turn;
    if (direction.z < 0.0) {
        // Folded over the edge u + v = 1.
        const double upper_u = u;
        u = 1.0 - v;
        v = 1.0 - upper_u;
    }
    return {0.5 * (std::copysign(u, direction.x) + 1.0), 0.5 * (std::copysign(v, direction.y) + 1.0)};
}

Imath::V2d wrapped_equal_area_place(Imath::V2d place) noexcept {
    if (place.x < 0.0 || place.x > 1.0) place = {place.x < 0.0 ? -place.x : 2.0 - place.x, 1.0 - place.y};
    if (place.y < 0.0 || place.y > 1.0) place = {1.0 - place.x, place.y < 0.0 ? -place.y : 2.0 - place.y};
    return place;
}

}  // namespace emulsion
