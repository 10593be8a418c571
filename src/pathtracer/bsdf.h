#pragma once
// How surfaces scatter light: radiance out of radiance in, and directions drawn accordingly.
//
// wo points to where the path came from, wi to where it goes on; unit vectors in the frame of the shading normal, z
// along it. f_cos is the BSDF times |wi.z|: of reflection, radiance per irradiance; of transmission, radiance per
// irradiance scaled by 1/eta^2, as radiance is when it is followed against its way into a medium. Densities are per
// steradian of wi, 0 where the direction is one of a few that a smooth surface leaves.
//
// Source: Pharr, Jakob & Humphreys, "Physically Based Rendering", 4th ed., chapter 9.

#include <array>
#include <cmath>

#include <Imath/ImathVec.h>

#include "spectrum/sampled_spectrum.h"

namespace emulsion {

/// For channel counts: those of kWavelengthCounts, and red, green and blue.
template <int N>
struct BsdfValue {
    SampledSpectrum<N> f_cos{0.0f};
    float pdf = 0.0f;
};

template <int N>
struct BsdfSample {
    SampledSpectrum<N> weight{0.0f};  ///< f_cos / pdf; all 0: nothing is scattered
    Imath::V3f wi{0.0f};
    float pdf = 0.0f;             ///< 0: wi is one of a few directions of a smooth surface
    float radiance_scale = 1.0f;  ///< by which entering a medium alone changed the weight: 1/eta^2
    /// The direction holds for the first channel only: weight[0] is N times its own, the others are 0.
    bool first_channel_only = false;
};

/// Wavelengths of a path, or its three colours, as far as a refraction has left it any.
enum class Channels { all, first_only };

/// wo mirrored about the unit vector m.
[[nodiscard]] inline Imath::V3f mirrored(const Imath::V3f& wo, const Imath::V3f& m) noexcept {
    return m * (2.0f * wo.dot(m)) - wo;
}

[[nodiscard]] inline bool same_side(const Imath::V3f& a, const Imath::V3f& b) noexcept { return a.z * b.z > 0.0f; }

/// The first channel's value for all, scaled so that its mean over the channels stays: the others are 0.
template <int N>
[[nodiscard]] SampledSpectrum<N> of_first_channel(float value) noexcept {
    SampledSpectrum<N> spectrum{0.0f};
    spectrum[0] = value * static_cast<float>(N);
    return spectrum;
}

}  // namespace emulsion
