#pragma once
// A film's options, as the C interface has them.

#include "capi/emulsion.h"
#include "film/film_options.h"

namespace emulsion::capi {

[[nodiscard]] emulsion_film_options default_film_options() noexcept;

/// What the caller's version of the struct does not have is as in the defaults.
/// \throws std::invalid_argument naming a field that is NULL, no number of its enum, or a name that is not known; what
/// is out of its range is left to validate(FilmOptions).
[[nodiscard]] FilmOptions film_options(const emulsion_film_options& given);

}  // namespace emulsion::capi
