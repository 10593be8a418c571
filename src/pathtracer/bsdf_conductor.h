#pragma once
// Metal: mirrors, or microfacets that are mirrors. Both sides of the surface reflect. Single scattering: what several
// microfacets pass on to each other is lost, as in pbrt-v4; tests/pathtracer/bsdf_test.cpp states how much.

#include "pathtracer/bsdf.h"
#include "pathtracer/ggx.h"

namespace emulsion {

template <int N>
struct ConductorBsdf {
    SampledSpectrum<N> eta, k;  ///< index of refraction eta + i k, relative to the medium outside
    Ggx<float> facets;
    bool smooth = true;
};

template <int N>
[[nodiscard]] BsdfValue<N> evaluate(const ConductorBsdf<N>& bsdf, const Imath::V3f& wo, const Imath::V3f& wi) noexcept;
template <int N>
[[nodiscard]] BsdfSample<N> sample(const ConductorBsdf<N>& bsdf, const Imath::V3f& wo, float u_lobe,
                                   std::array<float, 2> u) noexcept;

}  // namespace emulsion
