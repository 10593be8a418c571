#pragma once
// From the sums of a pixel to what it shows.

#include <cstdint>
#include <optional>
#include <span>

#include "core/color.h"
#include "film/exact_sum.h"
#include "film/film_channels.h"
#include "film/film_setup.h"
#include "film/weighted_sums.h"

namespace emulsion {

/// A pixel whose weights have a mean below this has no value. The weights of filters with negative lobes can cancel;
/// a quotient by such a sum is noise, magnified more than 1 / kMinMeanWeight = 64 times.
inline constexpr double kMinMeanWeight = 1.0 / 64.0;

/// All sums of one pixel. The spans are laid out as FilmChannels says.
struct PixelSums {
    WeightedSums weighted;
    std::uint32_t samples = 0;
    std::span<const ExactSum> channels = {};
    std::span<const SquareSum> squares = {};
};

/// Whether the weights of the pixel's samples leave it a value.
[[nodiscard]] bool has_value(const PixelSums& sums) noexcept;

/// The weighted mean of the samples, whatever is done against fireflies; none if the pixel has no value.
[[nodiscard]] std::optional<XYZd> mean_of(const PixelSums& sums) noexcept;

/// What the camera samples give: mean_of(), or the median of means if the film takes that (of an even number of groups
/// that have a value, the mean of the two in the middle); none if there is none.
[[nodiscard]] std::optional<XYZd> camera_value_of(const PixelSums& sums, const FilmSetup& setup) noexcept;

/// What the light splats give, over the number of light paths; 0 if there are none.
[[nodiscard]] XYZd light_value_of(const PixelSums& sums, const FilmSetup& setup, std::uint64_t light_paths) noexcept;

/// Variance and standard error, each of luminance or of X, Y and Z as FilmVariance says; 0 for a pixel without value
/// and for one with a single sample; without negative lobes also where n, below, is at most 1, as of one or two samples
/// far out under a narrow filter. Both hold for samples that are independent of each other. Stratified and
/// low-discrepancy samples do better, so that their error is overestimated.
///
/// Under filters without negative lobes, variance = n / (n - 1) (sum(w v^2) / sum(w) - R^2), R = sum(w v) / sum(w), and
/// n is Kish's effective number of samples, their number over the mean square weight that the filter has by itself
/// (FilmSetup): what n samples of weight 1 would be as good as. With weights of 1 that is the usual unbiased estimate;
/// with others samples near the pixel's centre count more, and it is exact, but for terms of the order of 1/n, for
/// samples that are independent of their weights.
///
/// Under filters with negative lobes (has_negative_lobes()) that variance would be too small at edges, down to 0: there
/// samples in a lobe count against it. These films have sums of squared weights, and
///     variance = m / (m - 1) sum(w^2 (v - R)^2) / sum(w^2),    n = sum(w)^2 / sum(w^2),
/// of m samples that reach the pixel: so the square of the standard error is that of a ratio of two means of m
/// independent pairs (w v, w), linearised, which is right to the order of 1/n for samples that depend on their weights
/// as well. Samples count by the squares of their weights, those in a lobe too.
/// Sources: Kish, "Survey Sampling", 1965, section 11.7, for n; Cochran, "Sampling Techniques", 3rd edition, 1977,
/// chapter 6, for ratios.
struct PixelVariance {
    XYZd variance;        ///< of the samples, at least 0; the square of cd/m^2 times the imaging ratio
    XYZd standard_error;  ///< of the pixel: sqrt(variance / n); cd/m^2 times the imaging ratio
};
[[nodiscard]] PixelVariance variance_of(const PixelSums& sums, const FilmSetup& setup) noexcept;

/// Mean radiance over a spectral bucket, W m^-2 sr^-1 nm^-1, light splats included; without the imaging ratio, and from
/// the plain mean of samples under MedianOfMeans. None if neither samples nor light paths have reached it.
[[nodiscard]] std::optional<double> bucket_radiance_of(const PixelSums& sums, const FilmSetup& setup, int bucket,
                                                       std::uint64_t light_paths) noexcept;

/// The weighted mean of a component of an auxiliary layer, over the samples that see something; 0 if fewer than one in
/// 64 do, or if their weights cancel to that. Under filters with negative lobes it may leave the range of the values.
[[nodiscard]] double aux_value_of(const PixelSums& sums, const FilmSetup& setup, std::size_t layer,
                                  std::size_t component) noexcept;

}  // namespace emulsion
