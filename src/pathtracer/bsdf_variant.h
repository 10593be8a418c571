#pragma once
// Every way to scatter but Lambertian reflection, which the integrator does itself.

#include <variant>

#include "core/visit.h"
#include "pathtracer/bsdf_coated_diffuse.h"
#include "pathtracer/bsdf_conductor.h"
#include "pathtracer/bsdf_dielectric.h"
#include "pathtracer/bsdf_diffuse.h"
#include "pathtracer/bsdf_thin_dielectric.h"

namespace emulsion {

template <int N>
using Bsdf = std::variant<ConductorBsdf<N>, DielectricBsdf<N>, ThinDielectricBsdf<N>, DiffuseTransmissionBsdf<N>,
                          CoatedDiffuseBsdf<N>>;

/// Whether all of its directions are a few of a smooth surface, so that no light is worth a shadow ray.
template <int N>
[[nodiscard]] bool is_smooth(const Bsdf<N>& bsdf) noexcept {
    return visit_noexcept(
        []<class B>(const B& b) {
            if constexpr (std::is_same_v<B, ThinDielectricBsdf<N>>) return true;
            if constexpr (requires { b.smooth; }) return b.smooth;
            return false;
        },
        bsdf);
}

template <int N>
[[nodiscard]] BsdfValue<N> evaluate(const Bsdf<N>& bsdf, const Imath::V3f& wo, const Imath::V3f& wi) noexcept {
    return visit_noexcept(
        [&]<class B>(const B& b) -> BsdfValue<N> {
            if constexpr (std::is_same_v<B, ThinDielectricBsdf<N>>) {
                return {};
            } else {
                return evaluate(b, wo, wi);
            }
        },
        bsdf);
}

/// Draws wi by three uniform numbers in [0, 1).
template <int N>
[[nodiscard]] BsdfSample<N> sample(const Bsdf<N>& bsdf, const Imath::V3f& wo, float u_lobe,
                                   std::array<float, 2> u) noexcept {
    return visit_noexcept([&](const auto& b) { return sample(b, wo, u_lobe, u); }, bsdf);
}

}  // namespace emulsion
