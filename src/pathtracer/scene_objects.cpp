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

std::vector<ShapeRange> settle_objects(Scene& scene) {
    std::vector<std::size_t> uses(scene.objects.size(), 0);
    std::vector<Imath::M44d> place(scene.objects.size());
    for (const ObjectInstance& instance : scene.instances) {
        const auto number = static_cast<std::size_t>(instance.object);
        // Embree takes a hierarchy of nothing for one that is out of its range.
        if (scene.objects.at(number).shapes.empty()) continue;
        ++uses[number];
        place[number] = instance.world_from_object;
    }

    std::vector<ShapeRange> ranges;
    std::vector<int> new_number(scene.objects.size(), 0);
    for (std::size_t number = 0; number < scene.objects.size(); ++number) {
        if (uses[number] == 0) continue;
        const std::size_t first = scene.shapes.size();
        for (Shape& shape : scene.objects[number].shapes) {
            shape.area_light.reset();
            if (uses[number] == 1) {
                std::visit([&](auto& geometry) { map_geometry(geometry, place[number]); }, shape.geometry);
            }
            scene.shapes.push_back(std::move(shape));
        }
        new_number[number] = static_cast<int>(ranges.size());
        if (uses[number] > 1) ranges.push_back({first, scene.shapes.size()});
    }
    std::erase_if(scene.instances,
                  [&](const ObjectInstance& i) { return uses[static_cast<std::size_t>(i.object)] <= 1; });
    for (ObjectInstance& instance : scene.instances) {
        instance.object = new_number[static_cast<std::size_t>(instance.object)];
    }
    scene.objects.clear();
    return ranges;
}

}  // namespace emulsion
