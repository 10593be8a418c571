#pragma once
// How many samples a film has, in words.

#include <cstdint>
#include <string>

#include "film/film_contents.h"
#include "film/film_provenance.h"

namespace emulsion::cli {

/// "samples 0-8 (and 8-16 in 3 of 12 tiles)", or "no samples": which a film has.
[[nodiscard]] std::string samples_text(const FilmProvenance& provenance);

/// "8", or "8 to 16".
[[nodiscard]] std::string count_text(std::uint64_t least, std::uint64_t most);
/// The same of samples taken of each pixel: by the account, or, where it doesn't know, by the film's sums.
[[nodiscard]] std::string count_text(const FilmProvenance& provenance, const FilmContents<ExactSums>& contents);

}  // namespace emulsion::cli
