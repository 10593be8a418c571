#pragma once
// The sphere of directions on the unit square, such that equal areas are equal solid angles: every part of the square
// of area a is seen under a solid angle of 4 pi a. The upper half z > 0 is the square on its tip in the middle, the
// lower half is folded outwards from it, so that the four corners are all (0, 0, -1).
// Source: P. Clarberg, "Fast Equal-Area Mapping of the (Hemi)Sphere using SIMD", Journal of Graphics Tools 13(3), 2008;
// u to +x, v to +y, as pbrt-v4 has it.

#include <Imath/ImathVec.h>

namespace emulsion {

/// The direction, of unit length, at a place (u, v) in [0, 1]^2.
[[nodiscard]] Imath::V3d equal_area_direction(const Imath::V2d& place) noexcept;

/// The place in [0, 1]^2 of a direction of unit length.
[[nodiscard]] Imath::V2d equal_area_place(const Imath::V3d& direction) noexcept;

/// The place in [0, 1]^2 of one that lies beyond an edge, by at most 1: there the square goes on with itself, turned
/// half round about the middle of that edge. Others are left alone.
[[nodiscard]] Imath::V2d wrapped_equal_area_place(Imath::V2d place) noexcept;

}  // namespace emulsion
