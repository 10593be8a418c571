#pragma once
// Colour differences as a picture to look at.

#include <optional>
#include <string>

#include "compare/difference_statistics.h"
#include "core/image.h"
#include "display/code_value.h"

namespace emulsion {

struct DifferenceMapOptions {
    /// What the last colour stands for, and all that is above; > 0, finite. Unset: scale_end().
    std::optional<double> end;
    std::string name = "ciede2000";  ///< of the difference, below the scale; letters of display/label.h
};

/// The end of a scale on which 99 of 100 pixels find their place: the first of 1, 2, 3, 5, 10, 20, ... that the 99th
/// percentile does not exceed. So a map of differences that nobody sees stays dark.
[[nodiscard]] double scale_end(const DifferenceStatistics& statistics) noexcept;

/// Pixel by pixel in the colours of DifferenceRamp, in codes of 8-bit sRGB; below that a scale with its numbers, and
/// mean, 99th percentile and maximum. Pixels without a difference (NaN) are grey, which is then said. Narrow pictures
/// get a margin at the right, so that the scale has room; letters grow with the picture.
/// \throws std::invalid_argument if the end of the scale is out of its range.
[[nodiscard]] Image<CodeRGB> difference_map(const Image<double>& differences, const DifferenceStatistics& statistics,
                                            const DifferenceMapOptions& options = {});

}  // namespace emulsion
