#pragma once
// From text back to a film's options.

#include <string>
#include <string_view>
#include <vector>

#include "film/film_options.h"

namespace emulsion {

/// What to_text(FilmOptions) printed, as the same options; size, crop window and sensor, which it leaves out, have
/// their defaults. \throws std::invalid_argument if the text is not exactly one that it prints.
[[nodiscard]] FilmOptions parse_film_options(std::string_view text);

/// Auxiliary layers by name, each with its components, which those of known_aux_layers() may leave out:
/// "albedo,depth:Z,roughness:value,motion:x+y"; "none". Their names are checked by validate(FilmOptions).
/// \throws std::invalid_argument for a layer without components that is not one of these, naming it.
[[nodiscard]] std::vector<AuxLayer> parse_aux_layers(std::string_view text);

/// The value of an option in such a text: of "variance" in "... variance=none ...", "none".
/// \throws std::invalid_argument if it has no such option.
[[nodiscard]] std::string_view film_option_text(std::string_view text, std::string_view name);

}  // namespace emulsion
