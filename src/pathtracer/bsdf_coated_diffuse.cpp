#include "pathtracer/bsdf_coated_diffuse.h"

#include <bit>
#include <numbers>

#include "core/random.h"
#include "pathtracer/channel_counts.h"
#include "pathtracer/fresnel.h"
#include "pathtracer/vector_math.h"

namespace emulsion {

namespace {

using Imath::V3f;

constexpr float kInvPi = std::numbers::inv_pi_v<float>;

float transmitted_by_coat(float thickness, float cosine) noexcept { return std::exp(-thickness / cosine); }

/// Everything is seen from the side of wo.
V3f upward(const V3f& w, bool below) noexcept { return below ? -w : w; }

// --- A smooth coat

/// A: what reaches the base from a direction with this cosine outside.
float smooth_transmission(float cosine, float eta, float thickness) noexcept {
    const float inside = std::sqrt(std::max(0.0f, refracted_cosine2(cosine, eta)));
    if (!(inside > 0.0f)) return 0.0f;
    return (1.0f - fresnel_dielectric(cosine, eta)) * transmitted_by_coat(thickness, inside);
}

// --- A rough coat, estimated

/// A: of one microfacet among those that w sees.
template <int N>
float estimated_transmission(const CoatedDiffuseBsdf<N>& bsdf, const V3f& w, Pcg32& random) noexcept {
    const float u0 = random.next_float();
    const V3f m = bsdf.facets.sample_visible(w, {u0, random.next_float()});
    const float cosine = std::min(w.dot(m), 1.0f);
    if (!(cosine > 0.0f)) return 0.0f;
    const float cosine_t = std::sqrt(std::max(0.0f, refracted_cosine2(cosine, bsdf.eta)));
    const V3f inside = -w * (1.0f / bsdf.eta) + m * (cosine / bsdf.eta - cosine_t);
    if (!(inside.z < 0.0f)) return 0.0f;
    const float masking = bsdf.facets.masking_shadowing(w, inside) / bsdf.facets.masking(w);
    return (1.0f - fresnel_dielectric(cosine, bsdf.eta)) * masking * transmitted_by_coat(bsdf.thickness, -inside.z);
}

/// K: of one direction from the base and one microfacet above it.
template <int N>
float estimated_reflection(const CoatedDiffuseBsdf<N>& bsdf, Pcg32& random) noexcept {
    const float u0 = random.next_float(), u1 = random.next_float(), u2 = random.next_float();
    const V3f up = cosine_hemisphere({u0, u1});
    if (!(up.z > 0.0f)) return 0.0f;
    const V3f m = bsdf.facets.sample_visible(up, {u2, random.next_float()}), back = mirrored(up, m);
    if (!(back.z > 0.0f)) return 0.0f;
    const float masking = bsdf.facets.masking_shadowing(up, back) / bsdf.facets.masking(up);
    return fresnel_dielectric(std::clamp(up.dot(m), 0.0f, 1.0f), 1.0f / bsdf.eta) * masking *
           transmitted_by_coat(bsdf.thickness, up.z) * transmitted_by_coat(bsdf.thickness, back.z);
}

// --- Both

/// rho times the sum of (rho K)^k over k < terms, by Horner's rule.
template <int N, class Reflectance>
SampledSpectrum<N> base_series(const CoatedDiffuseBsdf<N>& bsdf, Reflectance&& reflectance_of_coat) noexcept {
    SampledSpectrum<N> sum(bsdf.terms > 0 ? 1.0f : 0.0f);
    for (int k = 1; k < bsdf.terms; ++k)
        sum = SampledSpectrum<N>(1.0f) + bsdf.reflectance * sum * reflectance_of_coat();
    return bsdf.reflectance * sum;
}

/// Of light through the coat, both directions above: f_cos.
template <int N>
SampledSpectrum<N> through_coat(const CoatedDiffuseBsdf<N>& bsdf, const V3f& wo, const V3f& wi) noexcept {
    const float scale = wi.z * kInvPi / (bsdf.eta * bsdf.eta);
    if (bsdf.smooth_coat) {
        const float there_and_back = smooth_transmission(std::min(wo.z, 1.0f), bsdf.eta, bsdf.thickness) *
                                     smooth_transmission(std::min(wi.z, 1.0f), bsdf.eta, bsdf.thickness);
        return base_series(bsdf, [&bsdf] { return bsdf.internal_reflectance; }) * (there_and_back * scale);
    }
    std::uint64_t seed = bsdf.seed;
    for (const float v : {wi.x, wi.y, wi.z}) seed = hash_combine(seed, std::bit_cast<std::uint32_t>(v));
    Pcg32 random(seed);
    const float out = estimated_transmission(bsdf, wo, random);
    const float in = estimated_transmission(bsdf, wi, random);
    return base_series(bsdf, [&] { return estimated_reflection(bsdf, random); }) * (in * out * scale);
}

/// With which the coat's own reflection is drawn.
template <int N>
float coat_probability(const CoatedDiffuseBsdf<N>& bsdf, float cosine) noexcept {
    const float coat = fresnel_dielectric(std::min(cosine, 1.0f), bsdf.eta);
    const float base = (1.0f - coat) * (bsdf.terms > 0 ? bsdf.reflectance.max() : 0.0f);
    return coat + base > 0.0f ? coat / (coat + base) : 1.0f;
}

}  // namespace

template <int N>
BsdfValue<N> evaluate(const CoatedDiffuseBsdf<N>& bsdf, const V3f& wo_any, const V3f& wi_any) noexcept {
    if (!same_side(wo_any, wi_any)) return {};
    const bool below = wo_any.z < 0.0f;
    const V3f wo = upward(wo_any, below), wi = upward(wi_any, below);
    const float coat = coat_probability(bsdf, wo.z);
    BsdfValue<N> value{through_coat(bsdf, wo, wi), (1.0f - coat) * wi.z * kInvPi};
    if (bsdf.smooth_coat) return value;

    const V3f m = (wo + wi).normalized();
    const float seen = bsdf.facets.density(m) / (4.0f * wo.z);
    const float reflected = fresnel_dielectric(std::clamp(wo.dot(m), 0.0f, 1.0f), bsdf.eta);
    value.f_cos += SampledSpectrum<N>(seen * bsdf.facets.masking_shadowing(wo, wi) * reflected);
    value.pdf += coat * seen * bsdf.facets.masking(wo);
    return value;
}

template <int N>
BsdfSample<N> sample(const CoatedDiffuseBsdf<N>& bsdf, const V3f& wo_any, float u_lobe,
                     std::array<float, 2> u) noexcept {
    if (wo_any.z == 0.0f) return {};
    const bool below = wo_any.z < 0.0f;
    const V3f wo = upward(wo_any, below);
    const float coat = coat_probability(bsdf, wo.z);
    const bool by_coat = u_lobe < coat;
    if (by_coat && bsdf.smooth_coat) {
        const float reflected = fresnel_dielectric(std::min(wo.z, 1.0f), bsdf.eta);
        return {.weight = SampledSpectrum<N>(reflected / coat), .wi = {-wo_any.x, -wo_any.y, wo_any.z}};
    }
    const V3f wi = by_coat ? mirrored(wo, bsdf.facets.sample_visible(wo, u)) : cosine_hemisphere(u);
    if (!(wi.z > 0.0f)) return {};
    const BsdfValue<N> value = evaluate(bsdf, wo, wi);
    if (!(value.pdf > 0.0f)) return {};
    return {.weight = value.f_cos * (1.0f / value.pdf), .wi = upward(wi, below), .pdf = value.pdf};
}

double coat_internal_reflectance(double eta, double thickness) noexcept {
    // 2 F(c) exp(-2 thickness / c) c dc. The kink at the critical angle splits the integral; squared steps from it
    // smooth the square root that follows it. Midpoints, as the integrand vanishes with all derivatives at 0.
    const auto integrand = [&](double c) {
        return 2.0 * c * fresnel_dielectric(c, 1.0 / eta) * std::exp(-2.0 * thickness / c);
    };
    constexpr int kSteps = 1024;
    const double critical = eta > 1.0 ? std::sqrt(1.0 - 1.0 / (eta * eta)) : 0.0;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double s = (i + 0.5) / kSteps;
        sum += integrand(critical * s) * critical;
        sum += integrand(critical + (1.0 - critical) * s * s) * (1.0 - critical) * 2.0 * s;
    }
    return sum / kSteps;
}

#define EMULSION_INSTANTIATE(N)                                                                   \
    template BsdfValue<N> evaluate(const CoatedDiffuseBsdf<N>&, const V3f&, const V3f&) noexcept; \
    template BsdfSample<N> sample(const CoatedDiffuseBsdf<N>&, const V3f&, float, std::array<float, 2>) noexcept;
EMULSION_FOR_EACH_CHANNEL_COUNT(EMULSION_INSTANTIATE)

}  // namespace emulsion
