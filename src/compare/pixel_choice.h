#pragma once
// Half or float for a picture's file, by what half would do to this picture: measured, not predicted, as the picture is
// at hand when it is written.
//
// Half is taken if
//   - no value of a colour channel is too large for it, or so small that it would become 0;
//   - CIEDE2000 of what a file of halves would hold, against what one of floats would, is within the budget;
//   - no other channel that would be stored as half is damaged: has a value too large for it, or a root mean square
//     error above 2^-11 of its own root mean square. Half has 11 bits, and in its normal range, from 6.1e-5 on, does
//     better; so what fails has its light below that. Layers that are always float (film/exr_layers.h) do not count.
// Small values lose digits where nobody looks first: in the dark of a picture with bright light, below 6.1e-5 in the
// file's unit. CIEDE2000 is by the rule of spectrum/viewing_conditions.h, under which these are black.
// What a lossy compression does after the rounding is not looked at.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "compare/difference_statistics.h"
#include "film/exr_file.h"
#include "film/film_picture.h"
#include "film/pixel_type.h"
#include "spectrum/error_budget.h"
#include "spectrum/observer.h"

namespace emulsion {

/// The wish for half where its colour error is within the budget.
struct AutoPixels {
    ErrorBudget budget;
    bool operator==(const AutoPixels&) const = default;
};

using PixelChoice = std::variant<PixelType, AutoPixels>;

/// "half", "float", or "auto[:MEAN[,P99]]" as parse_auto() reads it.
/// \throws std::invalid_argument naming what was found and what was expected.
[[nodiscard]] PixelChoice parse_pixel_choice(std::string_view text);

/// What half does to a picture.
struct HalfLoss {
    DifferenceStatistics ciede2000;  ///< against float; of the pixels that are finite in both
    std::int64_t overflowing = 0;    ///< pixels with a value beyond 65504
    std::int64_t vanishing = 0;      ///< pixels with a value that is not 0, and would be
    /// Of the first of these in reading order, in the frame; both kinds apart.
    std::optional<std::pair<int, int>> first_overflowing_px, first_vanishing_px;
    std::string damaged_channel = {};  ///< the first, by its name in the file; empty: none
    double float_bytes = 2.0;          ///< of all channels as float over those with half, without compression
};

/// \param observer whose X, Y and Z they are: its white is that of CIELAB
/// \param options of the file; the pixel type does not count
/// \throws std::invalid_argument as write_exr().
[[nodiscard]] HalfLoss half_loss(const FilmPicture& picture, const ExrOptions& options, const Observer& observer);

struct PixelDecision {
    PixelType type = PixelType::float32;
    std::string reason;  ///< one line: "half: dE00 0.009 mean, 0.03 p99, within 1 and 3; ..."
};

/// By the rule above. \throws std::invalid_argument for a budget out of its range.
[[nodiscard]] PixelDecision decide_pixels(const HalfLoss& loss, const ErrorBudget& budget);

}  // namespace emulsion
