#pragma once
// Glass: a boundary of two dielectrics that reflects and refracts, smooth or of microfacets. z points to the outside.
//
// Where eta differs between the wavelengths of a path, refraction sends each into a direction of its own. The path then
// goes on with the first alone, whose weight is multiplied by their number while that of the others is 0: the mean over
// all stays that of the light. That is unbiased if each index of the arrangement has the same distribution, as the hero
// arrangement's have (spectrum/wavelength_sampling.h). Reflection at a smooth boundary keeps them all, where pbrt-v4
// ends them, too. At a rough boundary the others are to be given up before anything is evaluated.

#include "pathtracer/bsdf.h"
#include "pathtracer/ggx.h"

namespace emulsion {

template <int N>
struct DielectricBsdf {
    SampledSpectrum<N> eta;  ///< inside over outside, > 0
    Ggx<float> facets;
    bool smooth = true;
    bool disperses = false;  ///< eta differs between channels that the path still has; false if rough
};

template <int N>
[[nodiscard]] BsdfValue<N> evaluate(const DielectricBsdf<N>& bsdf, const Imath::V3f& wo, const Imath::V3f& wi) noexcept;
template <int N>
[[nodiscard]] BsdfSample<N> sample(const DielectricBsdf<N>& bsdf, const Imath::V3f& wo, float u_lobe,
                                   std::array<float, 2> u) noexcept;

}  // namespace emulsion
