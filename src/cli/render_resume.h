#pragma once

#include <filesystem>
#include <string>

#include "film/film_options.h"
#include "film/film_provenance.h"
#include "film/film_state.h"
#include "film/sample_ranges.h"

namespace emulsion::cli {

/// What a render would start with: a film of these options, of this scene and sampling, that is to have these samples.
struct RenderStart {
    FilmOptions film;
    FilmProvenance provenance;
    SampleRange samples;
};

/// A state from which the render can go on to what it would have been.
/// \throws IoError if the file is no whole film state; std::runtime_error naming the file if its film is another one,
/// or has samples that the render is not to have.
[[nodiscard]] FilmState read_state_for(const RenderStart& start, const std::filesystem::path& path);

}  // namespace emulsion::cli
