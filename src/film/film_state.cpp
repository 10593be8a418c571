#include "film/film_state.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "film/film_metadata.h"
#include "film/film_options_text.h"

namespace emulsion {

namespace {

/// What films must have in common.
struct FilmKind {
    const FilmOptions& options;
    const std::string& sensor_text;
    const FilmProvenance& provenance;
};

FilmKind kind_of(const FilmState& state) { return {state.options, state.sensor_text, state.provenance}; }

void require_same(std::string_view what, std::string_view a, std::string_view b) {
    if (a == b) return;
    throw std::invalid_argument(
        fmt::format("films do not belong together: {} is \"{}\" of one and \"{}\" of the other", what, a, b));
}

void require_same_kind(const FilmKind& a, const FilmKind& b) {
    const auto size = [](const FilmOptions& options) {
        return fmt::format("{}x{}", options.width_px, options.height_px);
    };
    require_same("size", size(a.options), size(b.options));
    require_same("crop window", to_string(bounds_of(a.options)), to_string(bounds_of(b.options)));
    const std::string a_text = to_text(a.options), b_text = to_text(b.options);
    for (const char* option :
         {"filter", "filter-use", "light-splats", "variance", "spectrum", "aux", "firefly-control"}) {
        require_same(option, film_option_text(a_text, option), film_option_text(b_text, option));
    }
    require_same("film", a_text, b_text);  // what the list above may lack
    if (without_camera_name(a.sensor_text) != without_camera_name(b.sensor_text)) {
        require_same("sensor", a.sensor_text, b.sensor_text);
    }
    require_same("scene", a.provenance.scene, b.provenance.scene);
    require_same("sampling", a.provenance.sampling, b.provenance.sampling);
}

void require_whole_rounds(const FilmProvenance& provenance) {
    if (!provenance.partial) return;
    const PartialRound& partial = *provenance.partial;
    throw std::invalid_argument(fmt::format(
        "a film with a partial round cannot be merged: samples {}-{} are done in {} of {} tiles, and have to be "
        "rendered to their end first",
        partial.samples.begin, partial.samples.end, std::count(partial.done.begin(), partial.done.end(), 1),
        partial.done.size()));
}

FilmOptions without_camera(FilmOptions options) {
    options.sensor.camera.reset();
    options.sensor.white_balance.reset();
    return options;
}

}  // namespace

FilmState state_of(const Film& film, FilmProvenance provenance, FilmMetadata run) {
    FilmContents<ExactSums> contents = film.contents();
    FilmMetadata metadata = metadata_of(contents, film.options(), provenance, std::move(run));
    return {without_camera(film.options()), to_text(film.options().sensor), std::move(contents), std::move(provenance),
            std::move(metadata)};
}

void require_same_film(const FilmState& state, const FilmOptions& options, const FilmProvenance& provenance) {
    require_same_kind(kind_of(state), {options, to_text(options.sensor), provenance});
}

void merge(FilmState& state, const FilmState& other) {
    if (&state == &other) throw std::invalid_argument("a film was to be merged with itself");
    require_same_kind(kind_of(state), kind_of(other));
    require_whole_rounds(state.provenance);
    require_whole_rounds(other.provenance);
    require_size(state.contents, state.options);
    require_size(other.contents, other.options);
    state.provenance.samples.add(other.provenance.samples);
    merge(state.contents, other.contents);
    update_counts(state.contents, state.options, state.provenance, state.metadata);
}

}  // namespace emulsion
