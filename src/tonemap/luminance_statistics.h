#pragma once
// What an operator needs to know about a whole picture: luminances in cd/m^2, and how many pixels of each class.
//
// Classes of pixels, the first that fits: nan (a component is NaN), negative (Y < 0, -Inf included), infinite (a
// component is infinite), zero (Y = 0), positive. nan, negative and infinite pixels are bad: counted and left out.

#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/color.h"
#include "core/image.h"
#include "tonemap/luminance_histogram.h"

namespace emulsion {

enum class PixelClass { positive, zero, negative, nan, infinite };

[[nodiscard]] inline PixelClass classify(const XYZ& pixel) noexcept {
    if (std::isnan(pixel.x) || std::isnan(pixel.y) || std::isnan(pixel.z)) return PixelClass::nan;
    if (pixel.y < 0.0f) return PixelClass::negative;
    if (std::isinf(pixel.x) || std::isinf(pixel.y) || std::isinf(pixel.z)) return PixelClass::infinite;
    return pixel.y == 0.0f ? PixelClass::zero : PixelClass::positive;
}

struct PixelCounts {
    std::int64_t positive = 0, zero = 0, negative = 0, nan = 0, infinite = 0;

    [[nodiscard]] std::int64_t bad() const noexcept { return negative + nan + infinite; }
    bool operator==(const PixelCounts&) const = default;
};

struct LuminanceStatistics {
    /// exp(mean of ln Y) over the positive pixels; 0 if there are none. Zeros are left out of both sum and count, so
    /// that the result scales with the unit. The paper's ln(delta + Y) does not: its delta is a luminance.
    double log_average_cdm2 = 0.0;
    double min_positive_cdm2 = 0.0;  ///< least positive luminance; 0 if there is none
    double max_cdm2 = 0.0;           ///< largest; 0 if no pixel is positive
    PixelCounts counts;
    std::optional<std::pair<int, int>> first_bad_px;  ///< (x, y) of the first bad pixel in reading order
    bool operator==(const LuminanceStatistics&) const = default;
};

/// The statistics, and how the luminances of the positive pixels are spread.
struct SceneLuminance {
    LuminanceStatistics statistics;
    LuminanceHistogram histogram;

    /// The ends of the range without its outliers: the brightest and the darkest thousandth of the positive pixels,
    /// rounded down, but at least one of 64 or more. Operators for which papers take the largest or the least luminance
    /// take these, so that a single pixel does not decide about a picture. 0 if no pixel is positive.
    [[nodiscard]] double robust_min_cdm2() const noexcept;
    [[nodiscard]] double robust_max_cdm2() const noexcept;
    bool operator==(const SceneLuminance&) const = default;
};

/// \throws std::invalid_argument if threads < 0.
[[nodiscard]] SceneLuminance scene_luminance(ImageView<const XYZ> scene, int threads);

/// The statistics alone.
/// Sums in double precision, row by row in a fixed order: the same bits for every number of threads (0: all).
/// ln is taken of products of up to 256 luminances, log-average within 1e-12 of the twin, relative.
/// Source: Reinhard et al. 2002, eq. 1, with 1/N inside the exponential, where it belongs, and without delta.
/// \throws std::invalid_argument if threads < 0.
[[nodiscard]] LuminanceStatistics luminance_statistics(ImageView<const XYZ> scene, int threads);

/// The double-precision twin: one ln for each pixel, one running sum.
[[nodiscard]] LuminanceStatistics luminance_statistics_reference(ImageView<const XYZ> scene);

}  // namespace emulsion
