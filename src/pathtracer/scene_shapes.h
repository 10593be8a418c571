#pragma once
// Shape directives to geometry in world space.
//
// Which way a mesh faces is settled here: flip_normal is set so that the geometric normal is the one that pbrt-v4 uses.
// Without N that is the cross product of the world-space edges, turned round if ReverseOrientation or a transformation
// that swaps handedness (but not both) says so; with N it is the side that the interpolated normal points to.
//
// That of a sphere or a cylinder is outward, and that of a disk +z, turned by the same rule. pbrt-v4 has that rule for
// the points that rays find, but leaves a mirroring transformation out when it samples such a shape as a light; an
// emitter must have one lit side, and PreparedScene gives it the latter's.

#include <string>
#include <vector>

#include <Imath/ImathMatrix.h>

#include "pathtracer/scene_files.h"
#include "pathtracer/scene_geometry.h"
#include "pathtracer/scene_parameters.h"
#include "pathtracer/scene_warnings.h"

namespace emulsion {

enum class Orientation { as_given, reversed };

struct ShapeFrame {
    Imath::M44d world_from_object;
    Orientation orientation = Orientation::as_given;
};

/// What reading needs and leaves behind.
struct ShapeReading {
    SceneFiles& files;
    SceneWarnings& warnings;
};

/// One shape; two for a file of triangles and quads. Triangles and patches without area are left out and counted in a
/// warning; if nothing is left, there is no shape. A bilinear mesh is marked as flat if all its patches are.
/// \throws SceneError naming the token at fault.
[[nodiscard]] std::vector<Geometry> read_shape(const ParameterList& list, const ShapeFrame& frame,
                                               ShapeReading reading);

/// Of each triangle or patch, or of the quadric: the area over which an AreaLightSource spreads its `power`. As in
/// pbrt-v4 a triangle or a bilinear patch is a light of its own with all of the power, so that a mesh of n triangles
/// gives n times as much; and the area of a quadric is taken before the transformation.
[[nodiscard]] std::vector<double> light_areas(const Geometry& geometry);

}  // namespace emulsion
