#pragma once
// Triangles as they are seen from a point: uniform directions towards one.
// Source: Arvo, "Stratified Sampling of Spherical Triangles", SIGGRAPH 1995; the solid angle after Van Oosterom &
// Strackee, "The Solid Angle of a Plane Triangle", IEEE Trans. Biomed. Eng. 30, 1983.

#include <array>

#include <Imath/ImathVec.h>

namespace emulsion {

struct SphericalTriangle {
    Imath::V3d a, b, c;        ///< unit vectors from the point to the corners
    double solid_angle = 0.0;  ///< in [0, 2 pi]; 0 if the point lies in the triangle's plane

    /// `pi` are the corners relative to the point; none of them is 0.
    SphericalTriangle(const Imath::V3d& p0, const Imath::V3d& p1, const Imath::V3d& p2) noexcept;
};

/// Whether the solid angle of the triangle with these corners, relative to the point, is above a given one below pi:
/// that half of which has the tangent `tan_half`. Quicker than the solid angle itself.
[[nodiscard]] bool is_seen_above(double tan_half, const Imath::V3d& p0, const Imath::V3d& p1,
                                 const Imath::V3d& p2) noexcept;

/// A unit vector, uniform in the triangle for u uniform in [0, 1)^2. The solid angle must be above 1e-6: below,
/// rounding shows.
[[nodiscard]] Imath::V3d sample(const SphericalTriangle& triangle, std::array<double, 2> u) noexcept;

}  // namespace emulsion
