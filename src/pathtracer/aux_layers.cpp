#include "pathtracer/aux_layers.h"

#include <stdexcept>

#include "pathtracer/surface_coordinates.h"

namespace emulsion {

void note_first_hits(const PreparedScene& scene, std::span<const Ray> rays, std::span<const Hit> hits,
                     std::span<FirstHit> first_hits) noexcept {
    const bool textured = !scene.scene().float_textures.empty() || !scene.scene().reflectance_textures.empty();
    for (std::size_t i = 0; i < hits.size(); ++i) {
        first_hits[i] = {};
        if (hits[i].shape == Hit::kNone) continue;
        const SurfacePoint point = surface_point(scene, rays[i], hits[i]);
        const Imath::V3f normal = point.shading_normal;
        const bool front = rays[i].direction.dot(normal) < 0.0f;
        first_hits[i] = {hits[i].shape, hits[i].t, front ? normal : -normal, {}};
        if (textured) first_hits[i].place = {point.position, surface_uv(scene, hits[i], point)};
    }
}

AuxLayers::AuxLayers(const Scene& scene, const std::vector<AuxLayer>& layers) : scene_(scene) {
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const AuxLayer known = known_aux_layer(layers[i].name);
        if (layers[i].components != known.components) {
            throw std::invalid_argument("auxiliary layer \"" + known.name + "\" has " +
                                        std::to_string(layers[i].components.size()) +
                                        " components, expected those of known_aux_layers()");
        }
        (known.name == "albedo" ? albedo_layer_ : known.name == "normal" ? normal_layer_ : depth_layer_) = i;
    }
    if (albedo_layer_) albedos_.emplace(scene);
}

template <class Add>
void AuxLayers::for_each(const FirstHit& hit, const Add& add) const noexcept {
    if (hit.shape == Hit::kNone) return;
    if (albedo_layer_) {
        add(*albedo_layer_, (*albedos_)(scene_.shapes[hit.shape].material, hit.place));
    }
    if (normal_layer_) {
        add(*normal_layer_, std::array{hit.facing_normal.x, hit.facing_normal.y, hit.facing_normal.z});
    }
    if (depth_layer_) add(*depth_layer_, std::array{hit.distance});
}

void AuxLayers::add(FilmTile& tile, int x, int y, float weight, const FirstHit& hit) const noexcept {
    for_each(hit, [&](std::size_t layer, std::span<const float> values) { tile.add_aux(x, y, layer, values, weight); });
}

void AuxLayers::add_at(FilmTile& tile, float x_px, float y_px, const FirstHit& hit) const noexcept {
    for_each(hit,
             [&](std::size_t layer, std::span<const float> values) { tile.add_aux_at(x_px, y_px, layer, values); });
}

}  // namespace emulsion
