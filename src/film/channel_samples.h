#pragma once
// What a sample adds to the further sums of a pixel (FilmChannels). Samples that are kept out, and weights that are not
// finite, must not get here; and the sums must be among the options' ones, unless it says otherwise.

#include <cstddef>
#include <span>

#include "core/color.h"
#include "film/film_channels.h"
#include "film/spectral_buckets.h"

namespace emulsion {

/// For variances. Adds nothing without them.
void add_squares(ChannelSums& channels, std::size_t pixel, XYZ value, float weight) noexcept;

/// To a group of MedianOfMeans.
void add_to_mean(ChannelSums& channels, std::size_t pixel, int group, XYZ value, float weight) noexcept;

/// `share` is what kept_share says of the sample.
void add_to_buckets(ChannelSums& channels, std::size_t pixel, const SpectralBuckets& buckets,
                    const SpectralSample& sample, float share, float weight) noexcept;

/// Light that arrives, in XYZ; `density` is its share in this pixel over the pixel's area in pixels.
void add_light(ChannelSums& channels, std::size_t pixel, XYZ value, double density) noexcept;

/// The same by wavelengths.
void add_light_to_buckets(ChannelSums& channels, std::size_t pixel, const SpectralBuckets& buckets,
                          const SpectralSample& sample, double density) noexcept;

/// Finite values of an auxiliary layer, as many as it has components.
void add_to_layer(ChannelSums& channels, std::size_t pixel, std::size_t layer, std::span<const float> values,
                  float weight) noexcept;

}  // namespace emulsion
