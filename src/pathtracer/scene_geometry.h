#pragma once
// Shapes as a scene describes them: in world space, or in that of the object which they belong to.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

#include "pathtracer/scene_light.h"

namespace emulsion {

/// Positions that MeshVertices::position should have capacity for beside its own: Embree reads 16 bytes at each of 12,
/// and is given a copy if there is no room behind the last.
inline constexpr std::size_t kRoomBehind = 1;

/// What the corners of a mesh's faces share.
struct MeshVertices {
    std::vector<Imath::V3f> position;
    std::vector<Imath::V3f> normal;   ///< shading normals: one a position, or none
    std::vector<Imath::V2f> uv;       ///< texture coordinates: one a position; none: those of the faces
    std::vector<Imath::V3f> tangent;  ///< the way of growing u, for what is brushed: one a position, or none
    /// Turns the geometric normal of the faces round; where `normal` has any, it is on their side instead.
    bool flip_normal = false;
};

/// Geometric normal: (p1 - p0) x (p2 - p0). Without uv, the corners have (0, 0), (1, 0) and (1, 1).
struct TriangleMesh : MeshVertices {
    std::vector<std::array<std::uint32_t, 3>> triangle;
};

/// Patches p(u, v) = (1 - v) ((1 - u) p00 + u p10) + v ((1 - u) p01 + u p11). Geometric normal: dp/du x dp/dv.
/// Without uv, texture coordinates are the patch's own.
struct BilinearMesh : MeshVertices {
    std::vector<std::array<std::uint32_t, 4>> patch;  ///< p00 p10 p01 p11
    /// Set if all patches are flat and convex (is_flat_and_convex in bilinear.h): they are then drawn as two triangles.
    bool flat = false;
};

// --- Quadrics, in double precision: world_from_object may be any invertible affine map. The normal of the unmapped shape
// is turned round if flip_normal is set.

/// The sphere of radius `radius` about the origin, or the part of it that has z in [z_min, z_max] and an angle about z,
/// from +x over +y, of at most phi_max. Normal: outward.
struct Sphere {
    Imath::M44d world_from_object;
    double radius = 1.0;  ///< > 0
    bool flip_normal = false;
    double z_min = -std::numeric_limits<double>::infinity(), z_max = std::numeric_limits<double>::infinity();
    double phi_max = 2.0 * std::numbers::pi;  ///< in (0, 2 pi]
};

/// A ring, or a part of it, about the z axis at z = `height`. Normal: +z.
struct Disk {
    Imath::M44d world_from_object;
    double height = 0.0;
    double radius = 1.0, inner_radius = 0.0;  ///< radius > inner_radius >= 0
    double phi_max = 2.0 * std::numbers::pi;  ///< in (0, 2 pi]
    bool flip_normal = false;
};

/// About the z axis, open at both ends. Normal: outward.
struct Cylinder {
    Imath::M44d world_from_object;
    double radius = 1.0;                      ///< > 0
    double z_min = -1.0, z_max = 1.0;         ///< z_min < z_max
    double phi_max = 2.0 * std::numbers::pi;  ///< in (0, 2 pi]
    bool flip_normal = false;
};

using Geometry = std::variant<TriangleMesh, BilinearMesh, Sphere, Disk, Cylinder>;

struct Shape {
    Geometry geometry;
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
