#pragma once
// What a film does against fireflies: samples so bright and so rare that one of them stays visible for thousands of
// others. Every such control is biased, so none is the default, and files say which one was at work and what it took
// away. core/named_value.h prints, parses and lists them.

#include <array>
#include <string_view>
#include <variant>

#include "core/named_value.h"

namespace emulsion {

/// Unbiased: every sample counts as it is.
struct NoFireflyControl {
    static constexpr std::string_view kName = "none";
    static constexpr std::string_view kHelp = "every sample counts as it is";
    bool operator==(const NoFireflyControl&) const = default;
};

/// A sample of more luminance is scaled down to this, its chromaticity kept. Darkens; by how much is summed up exactly.
struct LuminanceClamp {
    static constexpr std::string_view kName = "clamp";
    static constexpr std::string_view kHelp = "samples are scaled down to a largest luminance";
    /// Of the light, before the imaging ratio; finite, > 0, and in [1e-30, 1e30] together with it.
    float max_luminance_cdm2 = 1000.0f;
    bool operator==(const LuminanceClamp&) const = default;

    static constexpr std::array kParameters = {Parameter<LuminanceClamp>{
        "luminance", &LuminanceClamp::max_luminance_cdm2, kPositiveFinite, "cd/m^2", "the largest that is left"}};
};

/// A pixel's samples go round `groups` groups by their indices, and the pixel is the group whose mean luminance is the
/// median of them. A firefly spoils one group; a group in the middle is noisier than the mean of all, and where
/// luminance is skewed, as it is under fireflies, darker. The plain mean is kept beside the groups.
/// Source: Jerrum, Valiant & Vazirani, "Random Generation of Combinatorial Structures from a Uniform Distribution",
/// Theoretical Computer Science 43 (1986), for the estimator; Zirr, Hanika & Dachsbacher, "Re-Weighting Firefly Samples
/// for Improved Finite-Sample Monte Carlo Estimates", Computer Graphics Forum 37 (2018), for its use on pixels.
struct MedianOfMeans {
    static constexpr std::string_view kName = "median-of-means";
    static constexpr std::string_view kHelp = "the median, by luminance, of the means of groups of samples";
    static constexpr int kMostGroups = 63;
    int groups = 5;  ///< in [3, 63]
    bool operator==(const MedianOfMeans&) const = default;

    static constexpr std::array kParameters = {Parameter<MedianOfMeans>{
        "groups", &MedianOfMeans::groups, {3, kMostGroups}, "", "groups of samples; an odd number has a middle"}};
};

using FireflyControl = std::variant<NoFireflyControl, LuminanceClamp, MedianOfMeans>;

}  // namespace emulsion
