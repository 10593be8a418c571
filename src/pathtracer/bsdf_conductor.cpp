#include "pathtracer/bsdf_conductor.h"

#include "pathtracer/channel_counts.h"
#include "pathtracer/fresnel.h"

namespace emulsion {

namespace {

template <int N>
SampledSpectrum<N> fresnel(const ConductorBsdf<N>& bsdf, float cosine) noexcept {
    SampledSpectrum<N> reflectance;
    for (int i = 0; i < N; ++i) reflectance[i] = fresnel_conductor(cosine, bsdf.eta[i], bsdf.k[i]);
    return reflectance;
}

}  // namespace

template <int N>
BsdfValue<N> evaluate(const ConductorBsdf<N>& bsdf, const Imath::V3f& wo, const Imath::V3f& wi) noexcept {
    if (bsdf.smooth || !same_side(wo, wi)) return {};
    const Imath::V3f sum = wo + wi;
    if (!(sum.dot(sum) > 0.0f)) return {};
    const Imath::V3f m = sum.normalized(), up = wo.z < 0.0f ? -m : m;
    const float cosine = std::min(wo.dot(m), 1.0f);
    const float density = bsdf.facets.density(up) / (4.0f * std::abs(wo.z));
    return {fresnel(bsdf, cosine) * (density * bsdf.facets.masking_shadowing(wo, wi)),
            density * bsdf.facets.masking(wo)};
}

template <int N>
BsdfSample<N> sample(const ConductorBsdf<N>& bsdf, const Imath::V3f& wo, float, std::array<float, 2> u) noexcept {
    if (wo.z == 0.0f) return {};
    if (bsdf.smooth) {
        const float cosine = std::min(std::abs(wo.z), 1.0f);
        return {.weight = fresnel(bsdf, cosine), .wi = {-wo.x, -wo.y, wo.z}};
    }
    const Imath::V3f up = wo.z < 0.0f ? -wo : wo;
    const Imath::V3f m = bsdf.facets.sample_visible(up, u), wi = mirrored(up, m);
    if (!(wi.z > 0.0f)) return {};
    const float masking = bsdf.facets.masking(up);
    return {
        .weight = fresnel(bsdf, std::clamp(up.dot(m), 0.0f, 1.0f)) * (bsdf.facets.masking_shadowing(up, wi) / masking),
        .wi = wo.z < 0.0f ? -wi : wi,
        .pdf = masking * bsdf.facets.density(m) / (4.0f * up.z)};
}

#define EMULSION_INSTANTIATE(N)                                                                             \
    template BsdfValue<N> evaluate(const ConductorBsdf<N>&, const Imath::V3f&, const Imath::V3f&) noexcept; \
    template BsdfSample<N> sample(const ConductorBsdf<N>&, const Imath::V3f&, float, std::array<float, 2>) noexcept;
EMULSION_FOR_EACH_CHANNEL_COUNT(EMULSION_INSTANTIATE)

}  // namespace emulsion
