#pragma once
// Lambertian reflection and transmission: to both sides of a surface, from both.

#include <algorithm>
#include <numbers>

#include "pathtracer/bsdf.h"
#include "pathtracer/vector_math.h"

namespace emulsion {

template <int N>
struct DiffuseTransmissionBsdf {
    SampledSpectrum<N> reflectance, transmittance;

    /// With which the side is chosen.
    [[nodiscard]] float reflection_probability() const noexcept {
        const float r = reflectance.max(), t = transmittance.max();
        return r + t > 0.0f ? r / (r + t) : 1.0f;
    }
};

template <int N>
[[nodiscard]] BsdfValue<N> evaluate(const DiffuseTransmissionBsdf<N>& bsdf, const Imath::V3f& wo,
                                    const Imath::V3f& wi) noexcept {
    const bool reflects = same_side(wo, wi);
    const float cosine_pdf = std::abs(wi.z) * std::numbers::inv_pi_v<float>;
    const float probability = bsdf.reflection_probability();
    return {(reflects ? bsdf.reflectance : bsdf.transmittance) * cosine_pdf,
            cosine_pdf * (reflects ? probability : 1.0f - probability)};
}

template <int N>
[[nodiscard]] BsdfSample<N> sample(const DiffuseTransmissionBsdf<N>& bsdf, const Imath::V3f& wo, float u_lobe,
                                   std::array<float, 2> u) noexcept {
    const float probability = bsdf.reflection_probability();
    const bool reflects = u_lobe < probability;
    const float of_side = reflects ? probability : 1.0f - probability;
    Imath::V3f wi = cosine_hemisphere(u);
    if (!(wi.z > 0.0f)) return {};
    BsdfSample<N> sample;
    sample.pdf = of_side * wi.z * std::numbers::inv_pi_v<float>;
    sample.weight = (reflects ? bsdf.reflectance : bsdf.transmittance) * (1.0f / of_side);
    if ((wo.z < 0.0f) == reflects) wi.z = -wi.z;
    sample.wi = wi;
    return sample;
}

}  // namespace emulsion
