#include "pathtracer/aux_layers.h"

#include <stdexcept>
#include <variant>

#include "spectrum/reflectance_weights.h"
#include "spectrum/rgb_space.h"

namespace emulsion {

namespace {

std::vector<std::array<float, 3>> albedos_of(const std::vector<Material>& materials) {
    const ReflectanceRgb rgb = reflectance_rgb(rgb_space("sRGB"));
    std::vector<std::array<float, 3>> albedos;
    for (const Material& material : materials) {
        const auto [r, g, b] = weighted_sums(rgb.rgb_weights, std::get<DiffuseMaterial>(material).reflectance);
        albedos.push_back({static_cast<float>(r), static_cast<float>(g), static_cast<float>(b)});
    }
    return albedos;
}

}  // namespace

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
    if (albedo_layer_) material_albedo_ = albedos_of(scene.materials);
}

}  // namespace emulsion
