#include "pathtracer/scene_objects.h"

#include <optional>
#include <utility>

#include "pathtracer/scene_transform.h"

namespace emulsion {

namespace {

void map_vertices(MeshVertices& vertices, const Imath::M44d& map) {
    for (Imath::V3f& p : vertices.position) p = Imath::V3f(transform_point(map, Imath::V3d(p)));
    for (Imath::V3f& t : vertices.tangent) t = Imath::V3f(transform_vector(map, Imath::V3d(t)));
    if (const std::optional<Imath::M44d> of_normals = normal_matrix(map)) {
        for (Imath::V3f& n : vertices.normal) n = Imath::V3f(transform_vector(*of_normals, Imath::V3d(n)));
    }
    // The cross product of two edges is turned to the other side of the face; the face's own side must not be.
    if (swaps_handedness(map)) vertices.flip_normal = !vertices.flip_normal;
}
void map_geometry(TriangleMesh& mesh, const Imath::M44d& map) { map_vertices(mesh, map); }
void map_geometry(BilinearMesh& mesh, const Imath::M44d& map) { map_vertices(mesh, map); }
template <class Quadric>
void map_geometry(Quadric& quadric, const Imath::M44d& map) {
    quadric.world_from_object = quadric.world_from_object * map;
}

}  // namespace

Scene with_settled_objects(Scene scene) {
    if (scene.objects.empty()) return scene;

    // What stands where.
    std::vector<std::size_t> uses(scene.objects.size(), 0);
    std::vector<Imath::M44d> place(scene.objects.size());
    for (const Instance& instance : scene.instances) {
        ++uses[instance.object];
        place[instance.object] = instance.world_from_object;
    }
    std::vector<bool> in_object(scene.shapes.size(), false);
    for (const Object& object : scene.objects) {
        for (std::size_t i = object.first_shape; i < object.end_shape; ++i) {
            in_object[i] = true;
            scene.shapes[i].area_light.reset();
        }
    }

    // The shapes of the scene first, then those of one object after the other.
    std::vector<Shape> shapes;
    std::vector<Object> objects;
    std::vector<std::size_t> new_number(scene.objects.size(), 0);
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        if (!in_object[i]) shapes.push_back(std::move(scene.shapes[i]));
    }
    for (std::size_t number = 0; number < scene.objects.size(); ++number) {
        if (uses[number] == 0) continue;
        const Object& object = scene.objects[number];
        const std::size_t first = shapes.size();
        for (std::size_t i = object.first_shape; i < object.end_shape; ++i) {
            shapes.push_back(std::move(scene.shapes[i]));
            if (uses[number] > 1) continue;
            std::visit([&](auto& geometry) { map_geometry(geometry, place[number]); }, shapes.back().geometry);
        }
        new_number[number] = objects.size();
        if (uses[number] > 1) objects.push_back({first, shapes.size()});
    }
    std::erase_if(scene.instances, [&](const Instance& instance) { return uses[instance.object] == 1; });
    for (Instance& instance : scene.instances) instance.object = new_number[instance.object];
    scene.shapes = std::move(shapes);
    scene.objects = std::move(objects);
    return scene;
}

}  // namespace emulsion
