#pragma once
// What a render lost on its way to the file, and says so: nothing is repaired silently.

#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "film/exr_file.h"
#include "film/film.h"
#include "film/pixel_type.h"

namespace emulsion::cli {

/// Warns of samples that were kept out, of pixels without a value and of saturated ones.
/// \throws std::runtime_error if there are samples, and all were kept out: the picture would be black, whatever the
/// scene.
void warn_of_losses(const Film& film);

/// What to say of channel values that the file could not hold as they were, one sentence each. Here in the header so
/// that a test sees them all: a film's sums saturate long before 32-bit floats do.
[[nodiscard]] inline std::vector<std::string> exr_losses(const ExrWriteResult& written, PixelType pixel_type) {
    std::vector<std::string> losses;
    if (written.clamped_count > 0) {
        const bool is_half = pixel_type == PixelType::half;
        losses.push_back(fmt::format(
            "{} channel values are too large for {}-bit floats and were stored as {}, the "
            "largest, with their sign",
            written.clamped_count, is_half ? 16 : 32, is_half ? 65504.0f : std::numeric_limits<float>::max()));
    }
    if (written.non_finite_count > 0) {
        losses.push_back(
            fmt::format("{} channel values are NaN or infinite and were stored as such", written.non_finite_count));
    }
    return losses;
}

}  // namespace emulsion::cli
