#include "pathtracer/bsdf_dielectric.h"

#include "pathtracer/channel_counts.h"
#include "pathtracer/fresnel.h"

namespace emulsion {

namespace {

using Imath::V3f;

/// Everything below is seen from wo's side: z points to it, and eta is the far side's over the near side's.
V3f flipped_if(bool below, const V3f& w) noexcept { return {w.x, w.y, below ? -w.z : w.z}; }
float relative_eta(bool below, float eta) noexcept { return below ? 1.0f / eta : eta; }

/// wo refracted by the facet m; cosine = wo . m > 0, and there is no total reflection.
V3f refracted(const V3f& wo, const V3f& m, float cosine, float eta) noexcept {
    const float cosine_t = std::sqrt(std::max(0.0f, refracted_cosine2(cosine, eta)));
    return -wo * (1.0f / eta) + m * (cosine / eta - cosine_t);
}

template <int N>
BsdfSample<N> sample_smooth(const DielectricBsdf<N>& bsdf, const V3f& wo, float u_lobe) noexcept {
    const bool below = wo.z < 0.0f;
    const float cosine = std::min(std::abs(wo.z), 1.0f), first_eta = relative_eta(below, bsdf.eta[0]);

    // Reflection leaves in one direction whatever eta: all channels share the decision, by their mean.
    SampledSpectrum<N> reflectance(fresnel_dielectric(cosine, first_eta));
    float probability = reflectance[0];
    if (bsdf.disperses) {
        for (int i = 1; i < N; ++i) {
            reflectance[i] = fresnel_dielectric(cosine, relative_eta(below, bsdf.eta[i]));
            probability += reflectance[i];
        }
        probability /= static_cast<float>(N);
    }
    if (u_lobe < probability) return {.weight = reflectance * (1.0f / probability), .wi = {-wo.x, -wo.y, wo.z}};

    if (reflectance[0] >= 1.0f) return {};
    const float transmitted = (1.0f - reflectance[0]) / (1.0f - probability);
    BsdfSample<N> sample;
    sample.radiance_scale = 1.0f / (first_eta * first_eta);
    sample.weight = bsdf.disperses ? of_first_channel<N>(transmitted * sample.radiance_scale)
                                   : SampledSpectrum<N>(transmitted * sample.radiance_scale);
    sample.wi = flipped_if(below, refracted({wo.x, wo.y, cosine}, {0.0f, 0.0f, 1.0f}, cosine, first_eta)).normalized();
    sample.first_channel_only = bsdf.disperses;
    return sample;
}

}  // namespace

template <int N>
BsdfValue<N> evaluate(const DielectricBsdf<N>& bsdf, const V3f& wo_any, const V3f& wi_any) noexcept {
    if (bsdf.smooth || wo_any.z == 0.0f || wi_any.z == 0.0f) return {};
    const bool below = wo_any.z < 0.0f;
    const V3f wo = flipped_if(below, wo_any), wi = flipped_if(below, wi_any);
    const float eta = relative_eta(below, bsdf.eta[0]);

    // The facet that sends wo to wi: half way between them, or where their tangential parts are as 1 to eta.
    const bool reflects = wi.z > 0.0f;
    V3f m = reflects ? wo + wi : wo + wi * eta;
    const float length2 = m.dot(m);
    if (!(length2 > 0.0f)) return {};
    m *= std::copysign(1.0f / std::sqrt(length2), m.z);
    const float cosine_o = wo.dot(m), cosine_i = wi.dot(m);
    if (!(cosine_o > 0.0f) || (reflects ? cosine_i <= 0.0f : cosine_i >= 0.0f)) return {};

    const float reflectance = fresnel_dielectric(std::min(cosine_o, 1.0f), eta);
    const float seen = bsdf.facets.density(m) / wo.z;
    float facets = reflectance * seen / 4.0f, radiance_scale = 1.0f;
    if (!reflects) {
        const float sum = cosine_i + cosine_o / eta;
        facets = (1.0f - reflectance) * seen * cosine_o * -cosine_i / (sum * sum);
        radiance_scale = 1.0f / (eta * eta);
    }
    return {SampledSpectrum<N>(facets * bsdf.facets.masking_shadowing(wo, wi) * radiance_scale),
            facets * bsdf.facets.masking(wo)};
}

template <int N>
BsdfSample<N> sample(const DielectricBsdf<N>& bsdf, const V3f& wo_any, float u_lobe, std::array<float, 2> u) noexcept {
    if (wo_any.z == 0.0f) return {};
    if (bsdf.smooth) return sample_smooth(bsdf, wo_any, u_lobe);
    const bool below = wo_any.z < 0.0f;
    const V3f wo = flipped_if(below, wo_any);
    const float eta = relative_eta(below, bsdf.eta[0]);
    const V3f m = bsdf.facets.sample_visible(wo, u);
    const float cosine_o = std::min(wo.dot(m), 1.0f);
    if (!(cosine_o > 0.0f)) return {};

    const float reflectance = fresnel_dielectric(cosine_o, eta);
    const float seen = bsdf.facets.masking(wo) * bsdf.facets.density(m) / wo.z;
    BsdfSample<N> sample;
    V3f wi;
    if (u_lobe < reflectance) {
        wi = mirrored(wo, m);
        if (!(wi.z > 0.0f)) return {};
        sample.pdf = reflectance * seen / 4.0f;
    } else {
        wi = refracted(wo, m, cosine_o, eta);
        if (!(wi.z < 0.0f)) return {};
        const float cosine_i = wi.dot(m), sum = cosine_i + cosine_o / eta;
        sample.pdf = (1.0f - reflectance) * seen * cosine_o * std::abs(cosine_i) / (sum * sum);
        sample.radiance_scale = 1.0f / (eta * eta);
    }
    // The Fresnel factors and the density of facets are in the density, too.
    const float weight = bsdf.facets.masking_shadowing(wo, wi) / bsdf.facets.masking(wo) * sample.radiance_scale;
    sample.weight = SampledSpectrum<N>(weight);
    sample.wi = flipped_if(below, wi).normalized();
    return sample;
}

#define EMULSION_INSTANTIATE(N)                                                                \
    template BsdfValue<N> evaluate(const DielectricBsdf<N>&, const V3f&, const V3f&) noexcept; \
    template BsdfSample<N> sample(const DielectricBsdf<N>&, const V3f&, float, std::array<float, 2>) noexcept;
EMULSION_FOR_EACH_CHANNEL_COUNT(EMULSION_INSTANTIATE)

}  // namespace emulsion
