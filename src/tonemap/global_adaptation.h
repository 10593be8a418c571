#pragma once
// Adaptation to a picture, or a part of it, as a whole: one luminance in cd/m^2. Bad pixels are left out of all of
// them; zeros too, except out of the average.

#include <array>
#include <string_view>

#include "core/color.h"
#include "core/image.h"
#include "core/parameters.h"
#include "tonemap/scene_luminance.h"

namespace emulsion {

/// The mean of ln Y: SceneLuminance::log_average_cdm2().
struct LogAverageAdaptation {
    static constexpr std::string_view kName = "log-average";
    static constexpr std::string_view kHelp = "the geometric mean of the positive luminances";
    bool operator==(const LogAverageAdaptation&) const = default;
};

/// The mean of Y, without outliers (SceneLuminance::least_outlier_cdm2()).
struct AverageAdaptation {
    static constexpr std::string_view kName = "average";
    static constexpr std::string_view kHelp = "the arithmetic mean of the luminances";
    bool operator==(const AverageAdaptation&) const = default;
};

/// Half of the positive pixels are brighter; from LuminanceHistogram, to a bin's width.
struct MedianAdaptation {
    static constexpr std::string_view kName = "median";
    static constexpr std::string_view kHelp = "the median of the positive luminances";
    bool operator==(const MedianAdaptation&) const = default;
};

/// The log-average with the weights exp(-d^2 / (2 sigma^2)), d from the picture's centre, as of a camera's meter.
struct CentreWeightedAdaptation {
    static constexpr std::string_view kName = "centre-weighted";
    static constexpr std::string_view kHelp = "the log-average, pixels near the centre counting more";
    float sigma = 0.25f;  ///< of the shorter side; finite, > 0
    bool operator==(const CentreWeightedAdaptation&) const = default;

    static constexpr std::array kParameters = {Parameter<CentreWeightedAdaptation>{
        "sigma", &CentreWeightedAdaptation::sigma, kPositiveFinite, "of the shorter side", "width of the weights"}};
};

/// The log-average of a disc, as of a spot meter: the pixels whose centres lie in it, at least the one that its centre
/// lies in. If that has no positive pixel, that of the picture.
struct SpotAdaptation {
    static constexpr std::string_view kName = "spot";
    static constexpr std::string_view kHelp = "the log-average of a disc: what is to be the middle grey";
    float x = 0.5f;        ///< of the width, from the left; in [0, 1]
    float y = 0.5f;        ///< of the height, from the top; in [0, 1]
    float radius = 0.05f;  ///< of the shorter side; in [0, 1]
    bool operator==(const SpotAdaptation&) const = default;

    static constexpr std::array kParameters = {
        Parameter<SpotAdaptation>{"x", &SpotAdaptation::x, {0.0, 1.0}, "of the width", "centre, from the left"},
        Parameter<SpotAdaptation>{"y", &SpotAdaptation::y, {0.0, 1.0}, "of the height", "centre, from the top"},
        Parameter<SpotAdaptation>{
            "radius", &SpotAdaptation::radius, {0.0, 1.0}, "of the shorter side", "radius of the disc"}};
};

/// cd/m^2, > 0; the picture has positive pixels. Sums in double precision in a fixed order: the same bits for every
/// number of threads (0: all). \throws std::invalid_argument if threads < 0.
[[nodiscard]] double adaptation_cdm2(const LogAverageAdaptation& adaptation, ImageView<const XYZ> scene,
                                     const SceneLuminance& luminance, int threads);
[[nodiscard]] double adaptation_cdm2(const AverageAdaptation& adaptation, ImageView<const XYZ> scene,
                                     const SceneLuminance& luminance, int threads);
[[nodiscard]] double adaptation_cdm2(const MedianAdaptation& adaptation, ImageView<const XYZ> scene,
                                     const SceneLuminance& luminance, int threads);
[[nodiscard]] double adaptation_cdm2(const CentreWeightedAdaptation& adaptation, ImageView<const XYZ> scene,
                                     const SceneLuminance& luminance, int threads);
[[nodiscard]] double adaptation_cdm2(const SpotAdaptation& adaptation, ImageView<const XYZ> scene,
                                     const SceneLuminance& luminance, int threads);

}  // namespace emulsion
