#pragma once
// Shapes as a scene describes them.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

#include "pathtracer/scene_light.h"

namespace emulsion {

struct TriangleMesh {
    std::vector<Imath::V3f> position;  ///< world space
    std::vector<Imath::V3f> normal;    ///< shading normals in world space: one a position, or none
    std::vector<Imath::V2f> uv;  ///< texture coordinates: one a position; none: (0, 0), (1, 0), (1, 1) at each triangle
    std::vector<Imath::V3f> tangent;  ///< the way of growing u, for what is brushed: one a position, or none
    std::vector<std::array<std::uint32_t, 3>> triangle;
    /// Geometric normal: (p1 - p0) x (p2 - p0), turned round if set; where `normal` has any, on their side.
    bool flip_normal = false;
};

/// The sphere of radius `radius` about the origin of object space; world_from_object may be any invertible affine map.
struct Sphere {
    Imath::M44d world_from_object;
    double radius = 1.0;       ///< > 0
    bool flip_normal = false;  ///< outward normal, turned inward if set
};

struct Shape {
    std::variant<TriangleMesh, Sphere> geometry;
    int material = 0;  ///< index into Scene::materials
    std::optional<AreaLight> area_light;
};

/// Shapes that are in the scene once for each instance, and not by themselves. They have no lights.
struct ObjectDefinition {
    std::string name;
    std::vector<Shape> shapes;  ///< in the space of the object
};

struct ObjectInstance {
    int object = 0;  ///< index into Scene::objects
    Imath::M44d world_from_object;
};

}  // namespace emulsion
