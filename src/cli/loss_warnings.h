#pragma once
// What a render lost on its way to the file, and says so: nothing is repaired silently.

#include <string>
#include <vector>

#include "film/exr_file.h"
#include "film/film.h"
#include "film/pixel_type.h"

namespace emulsion::cli {

/// Warns of samples that were kept out or too faint, of pixels without a value and of saturated ones.
/// \throws std::runtime_error if there are samples, and all were kept out: the picture would be black, whatever the
/// scene.
void warn_of_losses(const Film& film);
void warn_of_losses(const FilmContents<ExactSums>& contents);

/// What to say of channel values that the file could not hold as they were, one sentence each.
[[nodiscard]] std::vector<std::string> exr_losses(const ExrWriteResult& written, PixelType pixel_type);

}  // namespace emulsion::cli
