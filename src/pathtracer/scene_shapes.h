#pragma once
// Shape directives to geometry in world space.
//
// Which way a mesh faces is settled here: flip_normal is set so that the geometric normal is the one that pbrt-v4 uses.
// Without N that is the cross product of the world-space edges, turned round if ReverseOrientation or a transformation
// that swaps handedness (but not both) says so; with N it is the side that the interpolated normal points to.
//
// A sphere's is outward, turned by ReverseOrientation alone, whatever the transformation. This departs from pbrt-v4
// under a mirroring one: there, a ray that meets the sphere finds its normal turned once more, while light sampling
// does not, so that the two disagree about which side is lit; ours holds with the latter everywhere.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Imath/ImathMatrix.h>

#include "pathtracer/scene.h"
#include "pathtracer/scene_parameters.h"

namespace emulsion {

enum class Orientation { as_given, reversed };

struct ShapeFrame {
    Imath::M44d world_from_object;
    Orientation orientation = Orientation::as_given;
};

using Geometry = std::variant<TriangleMesh, Sphere>;

struct ReadShape {
    Geometry geometry;
    /// Of each triangle, or of the sphere: the area over which an AreaLightSource spreads its `power`. As in pbrt-v4 a
    /// triangle or a bilinear patch is a light of its own with all of the power, so that a mesh of n triangles gives n
    /// times as much; and the area of a sphere is taken before the transformation.
    std::vector<double> light_areas;
};

/// Triangles without area are left out and counted in a warning; if none is left, the shape is unset.
///
/// A bilinear patch becomes two triangles: it must be flat (to 1e-5 of its diagonal) and convex.
/// \throws SceneError naming the token at fault.
[[nodiscard]] std::optional<ReadShape> read_shape(const ParameterList& list, const ShapeFrame& frame,
                                                  std::vector<std::string>& warnings);

}  // namespace emulsion
