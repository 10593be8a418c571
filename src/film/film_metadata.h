#pragma once
// What a film says about itself in the header of its files.

#include "film/exr_file.h"
#include "film/film.h"

namespace emulsion {

/// `run` (seed, renderer, command line) with all that the film knows: its counts, its options and what was done against
/// fireflies, with what that changed.
[[nodiscard]] FilmMetadata metadata_of(const Film& film, FilmMetadata run);
[[nodiscard]] FilmMetadata metadata_of(const FilmContents<ExactSums>& contents, const FilmOptions& options,
                                       FilmMetadata run);

/// FilmMetadata::firefly_control: empty for none; else the control and its bias, as measured on this film.
[[nodiscard]] std::string firefly_text(const FilmContents<ExactSums>& contents, const FilmOptions& options);

/// Brings what depends on the contents alone up to date: counts, and what was done against fireflies.
void update_counts(const FilmContents<ExactSums>& contents, const FilmOptions& options, FilmMetadata& metadata);

}  // namespace emulsion
