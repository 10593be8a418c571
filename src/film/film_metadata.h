#pragma once
// What a film says about itself in the header of its files.

#include "film/exr_file.h"
#include "film/film.h"
#include "film/film_provenance.h"

namespace emulsion {

/// `run` (seed, renderer, command line) with all that the film knows: its counts, its options, its sampling and what
/// was done against fireflies, with what that changed. Samples per pixel are those of `provenance`. Where that has none
/// they are the fewest that reach any pixel, without dropped ones; of a film that splats, whose samples reach several
/// pixels each, they are its samples over the pixels of its sample_bounds(), rounded down.
[[nodiscard]] FilmMetadata metadata_of(const Film& film, const FilmProvenance& provenance, FilmMetadata run);
[[nodiscard]] FilmMetadata metadata_of(const FilmContents<ExactSums>& contents, const FilmOptions& options,
                                       const FilmProvenance& provenance, FilmMetadata run);
/// The same of a film whose samples nobody has kept account of.
[[nodiscard]] FilmMetadata metadata_of(const Film& film, FilmMetadata run);

/// FilmMetadata::firefly_control: empty for none; else the control and its bias, as measured on this film.
[[nodiscard]] std::string firefly_text(const FilmContents<ExactSums>& contents, const FilmOptions& options);

/// Brings what depends on the contents alone up to date: counts, and what was done against fireflies.
void update_counts(const FilmContents<ExactSums>& contents, const FilmOptions& options,
                   const FilmProvenance& provenance, FilmMetadata& metadata);

}  // namespace emulsion
