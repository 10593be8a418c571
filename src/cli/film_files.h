#pragma once
// Files of films: the picture, and the film state from which a later run goes on.

#include <filesystem>
#include <optional>

#include "core/color.h"
#include "core/image.h"
#include "film/exr_file.h"
#include "film/film_state.h"
#include "pathtracer/film_in_progress.h"
#include "spectrum/error_budget.h"

namespace emulsion::cli {

/// Film and account as they belong together, even while threads add to them.
[[nodiscard]] FilmState state_of(const FilmInProgress& film, const FilmMetadata& run);

/// What settles the pixel type, if the options of a file don't.
struct AutoPixelType {
    std::optional<ErrorBudget> budget;  ///< of half; none: the type is that of the options
    bool quiet = false;                 ///< false: prints what was decided, in a line
};

/// Writes the film's picture and layers, or its state if the name says so; warns of what the file could not hold.
/// A decision on the pixel type stands in the header; a state, whose sums are exact, is written as the options say.
/// \returns the picture as the file holds it, for those who go on with it. \throws as write_exr.
Image<XYZ> write_film(const std::filesystem::path& output, const FilmInProgress& film, FilmMetadata run,
                      ExrOptions options, const AutoPixelType& pixels);
/// The same of a state, whose sensor tells the white luminance.
Image<XYZ> write_film(const std::filesystem::path& output, const FilmState& state, ExrOptions options,
                      const AutoPixelType& pixels);

}  // namespace emulsion::cli
