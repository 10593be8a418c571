#pragma once
// The two mesh shapes: triangles, and flat bilinear patches cut into triangles.

#include <optional>
#include <string>
#include <vector>

#include "pathtracer/scene_shapes.h"

namespace emulsion {

/// As read_shape for "trianglemesh" and "bilinearmesh", the list checked already.
[[nodiscard]] std::optional<ReadShape> read_triangle_mesh(const ParameterList& list, const ShapeFrame& frame,
                                                          std::vector<std::string>& warnings);
[[nodiscard]] std::optional<ReadShape> read_bilinear_mesh(const ParameterList& list, const ShapeFrame& frame,
                                                          std::vector<std::string>& warnings);

}  // namespace emulsion
