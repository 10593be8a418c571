#pragma once
// Transformations as scene files give them. pbrt thinks in column vectors (M p), Imath in row vectors (p M); every
// matrix here is Imath's, so that pbrt's "CTM = CTM * new" reads `new * ctm`. All maps are affine and invertible.

#include <array>
#include <optional>
#include <string_view>

#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

namespace emulsion {

/// The 16 numbers of a Transform directive: columns of pbrt's matrix one after the other, the translation in the last
/// four. That is Imath's matrix row by row.
[[nodiscard]] Imath::M44d matrix_of_columns(const std::array<double, 16>& numbers) noexcept;

[[nodiscard]] Imath::M44d translation(const Imath::V3d& offset) noexcept;
[[nodiscard]] Imath::M44d scaling(const Imath::V3d& factors) noexcept;

/// Counter-clockwise about the axis (any length but 0) for somebody it points at, if axes are right-handed.
[[nodiscard]] Imath::M44d rotation(double angle_deg, const Imath::V3d& axis) noexcept;

/// The map from world space to a camera space with the eye in the origin, z towards `look`, `up` in the half plane x =
/// 0, y > 0, and x = up cross z: left-handed. Singular if eye = look or up is along the line of sight.
[[nodiscard]] Imath::M44d look_at(const Imath::V3d& eye, const Imath::V3d& look, const Imath::V3d& up) noexcept;

/// Last column (of Imath's matrix) 0 0 0 1.
[[nodiscard]] bool is_affine(const Imath::M44d& matrix) noexcept;

/// Finite, and its three axes, scaled to unit length, span a volume of at least 1e-12.
[[nodiscard]] bool is_invertible(const Imath::M44d& affine) noexcept;

/// Whether the map turns left hands into right hands.
[[nodiscard]] bool swaps_handedness(const Imath::M44d& affine) noexcept;

[[nodiscard]] Imath::V3d transform_point(const Imath::M44d& affine, const Imath::V3d& point) noexcept;
[[nodiscard]] Imath::V3d transform_vector(const Imath::M44d& affine, const Imath::V3d& vector) noexcept;

/// Unset if the inverse is beyond double precision: is_invertible() looks at directions, not at lengths.
[[nodiscard]] std::optional<Imath::M44d> inverse_of(const Imath::M44d& affine) noexcept;

/// The matrix that transform_vector takes normals with: the inverse transpose, unset as inverse_of().
[[nodiscard]] std::optional<Imath::M44d> normal_matrix(const Imath::M44d& affine) noexcept;

/// The largest coordinate in world space. Embree drops what lies past about 1.8e18 without a word; this leaves room for
/// rays to start and end.
inline constexpr double kReach = 1e15;
inline constexpr std::string_view kWithinReach = "coordinates from -1e15 to 1e15 in world space";

/// Whether each coordinate is within kReach of 0.
[[nodiscard]] bool is_within_reach(const Imath::V3d& point) noexcept;

}  // namespace emulsion
