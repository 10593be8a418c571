#include "pathtracer/bsdf_thin_dielectric.h"

#include <algorithm>

#include "pathtracer/channel_counts.h"
#include "pathtracer/fresnel.h"

namespace emulsion {

template <int N>
BsdfSample<N> sample(const ThinDielectricBsdf<N>& bsdf, const Imath::V3f& wo, float u_lobe,
                     std::array<float, 2>) noexcept {
    const float cosine = std::min(std::abs(wo.z), 1.0f);
    SampledSpectrum<N> reflectance, transmittance;
    float probability = 0.0f;
    for (int i = 0; i < N; ++i) {
        const float one_face = fresnel_dielectric(cosine, bsdf.eta[i]);
        reflectance[i] = 2.0f * one_face / (1.0f + one_face);
        transmittance[i] = 1.0f - reflectance[i];
        probability += reflectance[i] / static_cast<float>(N);
    }
    if (u_lobe < probability) return {.weight = reflectance * (1.0f / probability), .wi = {-wo.x, -wo.y, wo.z}};
    if (!(probability < 1.0f)) return {};
    return {.weight = transmittance * (1.0f / (1.0f - probability)), .wi = -wo};
}

#define EMULSION_INSTANTIATE(N)                                                           \
    template BsdfSample<N> sample(const ThinDielectricBsdf<N>&, const Imath::V3f&, float, \
                                  std::array<float, 2>) noexcept;
EMULSION_FOR_EACH_CHANNEL_COUNT(EMULSION_INSTANTIATE)

}  // namespace emulsion
