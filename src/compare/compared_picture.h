#pragma once
// What is compared: a scene-referred picture, where it lies in its frame, and how noisy its pixels are, as far as that
// is known.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/color.h"
#include "core/image.h"
#include "film/exr_file.h"

namespace emulsion {

/// Of which components of the pixels a picture knows the noise.
enum class KnownNoise { none, luminance, xyz };

/// What the standard errors are of the noise.
enum class NoiseEstimate {
    unbiased,
    upper_bound,  ///< that of independent samples, where the picture's are stratified, and do better
};

struct ComparedPicture {
    Image<XYZ> xyz;                       ///< Y in cd/m^2
    PixelBounds window = {};              ///< where xyz lies in the frame
    int width_px = 0, height_px = 0;      ///< of the frame; both >= 1
    KnownNoise noise = KnownNoise::none;  ///< what standard_error holds
    Image<XYZ> standard_error = {};       ///< of each pixel, cd/m^2, >= 0; Y alone for luminance; NaN where unknown
    NoiseEstimate estimate = NoiseEstimate::unbiased;
    std::string observer = "cie_1931_2deg";  ///< whose XYZ it is: a name that observer() takes
    std::vector<std::uint64_t> seeds = {};   ///< of its noise, as far as files tell
    std::vector<std::string> notes = {};     ///< what was assumed or left out in reading, one sentence each
};

/// The noise is that of the layers "standard-error.Y", or of ".X", ".Y" and ".Z", in the file's units; unknown for
/// pixels of fewer than two samples by the layer "samples". The observer is the one that the film's options name, if
/// they do. The noise is an upper bound where the film's sampling is known and isn't that of independent samples.
[[nodiscard]] ComparedPicture compared_picture(FilmImage image);

/// The mean of two pictures of one scene with independent noise, and its own noise as the two tell it: a standard error
/// of half their difference in each pixel, whose square is an unbiased estimate whatever the sampler. (The standard
/// errors of films are for independent samples, and too large for stratified ones.) Notes of both. \throws
/// std::invalid_argument if frame, window or observer differ, or a seed is the same.
[[nodiscard]] ComparedPicture mean_of(const ComparedPicture& first, const ComparedPicture& second);

/// A seed that both have. Then they may share samples: their noise is not independent.
[[nodiscard]] std::optional<std::uint64_t> common_seed(const ComparedPicture& a, const ComparedPicture& b);

/// The pixels that both have. \throws std::invalid_argument if their frames differ in size, or there are none.
[[nodiscard]] PixelBounds common_window(const ComparedPicture& a, const ComparedPicture& b);

/// The part inside `window`, which must lie in the picture's own.
[[nodiscard]] ComparedPicture cropped(const ComparedPicture& picture, const PixelBounds& window);

}  // namespace emulsion
