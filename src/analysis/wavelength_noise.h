#pragma once
// How noisy the colour of a pixel is because paths carry a few wavelengths of all.

#include "analysis/pilot.h"
#include "spectrum/viewing_conditions.h"
#include "spectrum/wavelength_sampler.h"

namespace emulsion {

/// Mean square CIEDE2000 of one pixel of the pilot if each of `samples` independent paths draws `wavelengths` of them
/// by `sampler`, and has the pixel's mean radiance: light's own variance comes on top. `light` is the scene's, at whole
/// nanometres: within a band, the radiance has its shape.
[[nodiscard]] double wavelength_noise(const PilotChannels& channels, const ChannelValues& pixel,
                                      std::span<const double> light, const WavelengthSampler& sampler, int wavelengths,
                                      double samples, const ViewingConditions& viewing);

}  // namespace emulsion
