#pragma once
// Files of films: the picture, and the film state from which a later run goes on.

#include <filesystem>

#include "core/color.h"
#include "core/image.h"
#include "film/exr_file.h"
#include "film/film_state.h"
#include "pathtracer/film_in_progress.h"

namespace emulsion::cli {

/// Film and account as they belong together, even while threads add to them.
[[nodiscard]] FilmState state_of(const FilmInProgress& film, const FilmMetadata& run);

/// Writes the film's picture and layers, or its state if the name says so; warns of what the file could not hold.
/// \returns the picture as the file holds it, for those who go on with it. \throws as write_exr.
Image<XYZ> write_film(const std::filesystem::path& output, const FilmInProgress& film, const FilmMetadata& run,
                      const ExrOptions& options);
/// The same of a state, whose sensor tells the white luminance.
Image<XYZ> write_film(const std::filesystem::path& output, const FilmState& state, ExrOptions options);

}  // namespace emulsion::cli
