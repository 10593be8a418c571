#include "pathtracer/scene_transform.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace emulsion {

namespace {

Imath::V3d axis_of(const Imath::M44d& matrix, int row) noexcept {
    return {matrix[row][0], matrix[row][1], matrix[row][2]};
}

bool is_finite(const Imath::M44d& matrix) noexcept {
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            if (!std::isfinite(matrix[row][column])) return false;
        }
    }
    return true;
}

/// Unit length; (0, 0, 0) if that can't be. Scaled first, so that squares neither overflow nor vanish.
Imath::V3d unit(Imath::V3d v) noexcept {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 0.0) || !std::isfinite(largest)) return Imath::V3d(0.0);
    v /= largest;
    return v / std::sqrt(v.dot(v));
}

Imath::M44d frame(const Imath::V3d& x, const Imath::V3d& y, const Imath::V3d& z, const Imath::V3d& origin) noexcept {
    return {x.x, x.y, x.z, 0.0, y.x, y.y, y.z, 0.0, z.x, z.y, z.z, 0.0, origin.x, origin.y, origin.z, 1.0};
}

}  // namespace

Imath::M44d matrix_of_columns(const std::array<double, 16>& numbers) noexcept {
    Imath::M44d matrix;
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = numbers[static_cast<std::size_t>(i)];
    return matrix;
}

Imath::M44d translation(const Imath::V3d& offset) noexcept {
    return frame({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, offset);
}

Imath::M44d scaling(const Imath::V3d& factors) noexcept {
    return frame({factors.x, 0.0, 0.0}, {0.0, factors.y, 0.0}, {0.0, 0.0, factors.z}, Imath::V3d(0.0));
}

Imath::M44d rotation(double angle_deg, const Imath::V3d& axis) noexcept {
    const double angle = std::fmod(angle_deg, 360.0) * std::numbers::pi / 180.0;
    const double c = std::cos(angle), s = std::sin(angle);
    const Imath::V3d a = unit(axis);
    // Rodrigues' formula for each of the three base vectors.
    const auto turned = [&](const Imath::V3d& v) { return v * c + a.cross(v) * s + a * (a.dot(v) * (1.0 - c)); };
    return frame(turned({1.0, 0.0, 0.0}), turned({0.0, 1.0, 0.0}), turned({0.0, 0.0, 1.0}), Imath::V3d(0.0));
}

Imath::M44d look_at(const Imath::V3d& eye, const Imath::V3d& look, const Imath::V3d& up) noexcept {
    const Imath::V3d z = unit(look - eye);
    const Imath::V3d across = unit(up).cross(z);
    const Imath::V3d x = across.dot(across) > 1e-24 ? unit(across) : Imath::V3d(0.0);
    const Imath::V3d y = z.cross(x);
    // The frame is orthonormal: its inverse is its transpose.
    return frame({x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}, {-eye.dot(x), -eye.dot(y), -eye.dot(z)});
}

bool is_affine(const Imath::M44d& matrix) noexcept {
    return matrix[0][3] == 0.0 && matrix[1][3] == 0.0 && matrix[2][3] == 0.0 && matrix[3][3] == 1.0;
}

bool is_invertible(const Imath::M44d& affine) noexcept {
    if (!is_finite(affine)) return false;
    const Imath::V3d x = unit(axis_of(affine, 0)), y = unit(axis_of(affine, 1)), z = unit(axis_of(affine, 2));
    return std::abs(x.cross(y).dot(z)) >= 1e-12;
}

bool swaps_handedness(const Imath::M44d& affine) noexcept {
    return unit(axis_of(affine, 0)).cross(unit(axis_of(affine, 1))).dot(unit(axis_of(affine, 2))) < 0.0;
}

Imath::V3d transform_point(const Imath::M44d& affine, const Imath::V3d& point) noexcept {
    return transform_vector(affine, point) + axis_of(affine, 3);
}

Imath::V3d transform_vector(const Imath::M44d& affine, const Imath::V3d& vector) noexcept {
    return axis_of(affine, 0) * vector.x + axis_of(affine, 1) * vector.y + axis_of(affine, 2) * vector.z;
}

std::optional<Imath::M44d> inverse_of(const Imath::M44d& affine) noexcept {
    Imath::M44d inverse;
    try {
        inverse = affine.inverse(true);
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
    return is_finite(inverse) ? std::optional(inverse) : std::nullopt;
}

std::optional<Imath::M44d> normal_matrix(const Imath::M44d& affine) noexcept {
    const std::optional<Imath::M44d> inverse = inverse_of(affine);
    return inverse ? std::optional(inverse->transposed()) : std::nullopt;
}

bool is_within_reach(const Imath::V3d& point) noexcept {
    return std::abs(point.x) <= kReach && std::abs(point.y) <= kReach && std::abs(point.z) <= kReach;
}

}  // namespace emulsion
