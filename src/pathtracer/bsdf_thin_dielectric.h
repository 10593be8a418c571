#pragma once
// A pane of glass without thickness: a mirror, and a filter that bends no ray. The light that goes back and forth
// between its two faces is summed: with R of one face, R' = 2 R / (1 + R).

#include "pathtracer/bsdf.h"

namespace emulsion {

template <int N>
struct ThinDielectricBsdf {
    SampledSpectrum<N> eta;  ///< of the pane over that of the medium around it
};

template <int N>
[[nodiscard]] BsdfSample<N> sample(const ThinDielectricBsdf<N>& bsdf, const Imath::V3f& wo, float u_lobe,
                                   std::array<float, 2> u) noexcept;

}  // namespace emulsion
