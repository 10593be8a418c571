#pragma once
// A Lambertian base under a dielectric coat, on both sides of a surface: the coat reflects, refracts, and absorbs by
// exp(-thickness / cos) at each crossing, as pbrt-v4's does even without a medium in it.
//
// Since the base forgets where light came from, what comes back through the coat is separable:
//     f = rho / (pi eta^2) A(wo) A(wi) sum over k < terms of (rho K)^k,
// with A the share of light that reaches the base from a direction, and K the share of light from the base that the
// coat sends back to it. pbrt-v4 follows random walks of `maxdepth` events, of which every other meets the base: with
// terms = ceil(maxdepth / 2) ours has their mean. For a smooth coat A and K are numbers, and nothing is random beside
// the direction; for a rough one both are estimated without bias, from few microfacets, by numbers that are a hash of
// the seed and the direction.
// Source of the walk: Guo, Hasan & Zhao, "Position-Free Monte Carlo Simulation for Arbitrary Layered BSDFs", SIGGRAPH
// Asia 2018.

#include <cstdint>

#include "pathtracer/bsdf.h"
#include "pathtracer/ggx.h"

namespace emulsion {

template <int N>
struct CoatedDiffuseBsdf {
    SampledSpectrum<N> reflectance;     ///< rho of the base
    float eta = 1.5f;                   ///< of the coat over that outside, of all channels that the path still has
    float thickness = 0.01f;            ///< in mean free paths; >= 0
    int terms = 5;                      ///< >= 0
    float internal_reflectance = 0.0f;  ///< K of a smooth coat
    Ggx<float> facets;
    bool smooth_coat = true;
    std::uint64_t seed = 0;  ///< of a rough coat's estimates
};

template <int N>
[[nodiscard]] BsdfValue<N> evaluate(const CoatedDiffuseBsdf<N>& bsdf, const Imath::V3f& wo,
                                    const Imath::V3f& wi) noexcept;
template <int N>
[[nodiscard]] BsdfSample<N> sample(const CoatedDiffuseBsdf<N>& bsdf, const Imath::V3f& wo, float u_lobe,
                                   std::array<float, 2> u) noexcept;

/// K of a smooth coat: the mean of the coat's reflectance from below, weighted with the cosine and with what is
/// absorbed on the way there and back. To 1e-6.
[[nodiscard]] double coat_internal_reflectance(double eta, double thickness) noexcept;

}  // namespace emulsion
