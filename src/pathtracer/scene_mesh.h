#pragma once
// The mesh shapes: triangles and bilinear patches, from the scene's text and from PLY files.

#include <string>
#include <vector>

#include "pathtracer/scene_shapes.h"

namespace emulsion {

/// As read_shape for "trianglemesh", "bilinearmesh" and "plymesh", the list checked already.
[[nodiscard]] std::vector<Geometry> read_triangle_mesh(const ParameterList& list, const ShapeFrame& frame,
                                                       ShapeReading& reading);
[[nodiscard]] std::vector<Geometry> read_bilinear_mesh(const ParameterList& list, const ShapeFrame& frame,
                                                       ShapeReading& reading);
[[nodiscard]] std::vector<Geometry> read_ply_mesh(const ParameterList& list, const ShapeFrame& frame,
                                                  ShapeReading& reading);

}  // namespace emulsion
