// Scattering by all materials but diffuse ones. Apart from the integrator, whose file is as long as the compiler
// inlines well.

#include "pathtracer/light_sampling.h"
#include "pathtracer/surface_coordinates.h"

namespace emulsion {

template <class Transport>
bool PathIntegrator<Transport>::scatter_material(PathT& path, std::uint32_t path_index,
                                                 const PreparedMaterial& material, const Vertex& vertex, int depth) {
    const SurfacePoint& point = vertex.point;
    const PreparedMaterials& materials = scene_.materials();
    if constexpr (Transport::kSpectral) {
        if (path.channels == Channels::all && materials.needs_one_channel(material, vertex.place)) {
            path.throughput *= of_first_channel<Transport::kChannels>(1.0f);
            path.channels = Channels::first_only;
        }
    }
    if constexpr (Transport::kMarksDispersion) {
        if (PreparedMaterials::disperses(material)) path.throughput[Transport::kChannels - 1] = 0.0f;
    }
    std::uint64_t seed = 0;
    if (materials.is_estimated(material)) seed = static_cast<std::uint64_t>(path.samples.next_1d_fine() * 0x1p48);
    const auto bsdf = materials.template bsdf<Transport>(material, vertex.place, path.index, path.channels, seed);

    const Frame frame = materials.is_anisotropic(material)
                            ? Frame(point.shading_normal, surface_tangent(scene_, vertex.hit, point))
                            : Frame(point.shading_normal);
    const Imath::V3f wo = frame.to_local(-path.ray.direction);
    if (!is_smooth(bsdf)) {
        sample_light(path, path_index, point,
                     [&](const Imath::V3f& wi) { return evaluate(bsdf, wo, frame.to_local(wi)); });
    }

    const float u_lobe = path.samples.next_1d();
    const auto next = sample(bsdf, wo, u_lobe, path.samples.next_2d());
    path.throughput *= next.weight;
    if (!(path.throughput.max() > 0.0f)) return false;
    if (next.first_channel_only) path.channels = Channels::first_only;
    path.eta_scale /= next.radiance_scale;
    path.direction_pdf = next.pdf;
    path.ray.direction = unit(frame.to_world(next.wi));
    path.ray.origin = point.origin_towards(path.ray.direction);
    return survives_roulette(path, depth);
}

#define EMULSION_INSTANTIATE(TRANSPORT)                                                        \
    template bool PathIntegrator<TRANSPORT>::scatter_material(Path<TRANSPORT>&, std::uint32_t, \
                                                              const PreparedMaterial&, const Vertex&, int);
EMULSION_FOR_EACH_TRANSPORT(EMULSION_INSTANTIATE)

}  // namespace emulsion
