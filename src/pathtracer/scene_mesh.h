#pragma once
// The two mesh shapes: triangles, and flat bilinear patches cut into triangles.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pathtracer/scene_shapes.h"

namespace emulsion {

/// As read_shape for "trianglemesh" and "bilinearmesh", the list checked already.
[[nodiscard]] std::optional<Geometry> read_triangle_mesh(const ParameterList& list, const ShapeFrame& frame,
                                                         std::vector<std::string>& warnings);
[[nodiscard]] std::optional<Geometry> read_bilinear_mesh(const ParameterList& list, const ShapeFrame& frame,
                                                         std::vector<std::string>& warnings);

/// The cross product of two edges, (p1 - p0) x (p2 - p0): twice the area long.
[[nodiscard]] Imath::V3d edge_cross(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle) noexcept;

}  // namespace emulsion
