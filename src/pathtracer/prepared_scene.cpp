#include "pathtracer/prepared_scene.h"

#include <numeric>
#include <utility>

#include "pathtracer/scene_objects.h"

namespace emulsion {

PreparedScene::PreparedScene(Scene scene, int threads, const TransportModel& model, std::size_t many_triangles)
    : scene_(std::move(scene)) {
    const std::vector<ShapeRange> objects = settle_objects(scene_);
    accelerator_ = std::make_unique<Accelerator>(scene_, objects, threads, many_triangles);
    materials_ = std::make_unique<PreparedMaterials>(scene_, spectra_);

    LightPowers powers;
    shapes_.reserve(scene_.shapes.size());
    for (const Shape& shape : scene_.shapes) add_shape(shape, powers);
    instances_.reserve(scene_.instances.size());
    for (const ObjectInstance& instance : scene_.instances) instances_.emplace_back(instance.world_from_object);
    for (const Light& light : scene_.lights) add_light(light, powers);
    flux_ = powers.emitter;
    prepare_for(model);
    if (emitters_.empty()) return;
    const std::vector<double> weights = powers.weights();
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        emitters_[i].selection_probability = static_cast<float>(weights[i] / total);
    }
    picker_ = EmitterPicker(weights);
}

}  // namespace emulsion
