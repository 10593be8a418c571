#pragma once
// A film state but its pixels, as text attributes of a header; and back.

#include <cstdint>
#include <string>

#include "film/film_state.h"

namespace emulsion {

/// The attributes' names stand in for_each_state_field().
struct FilmStateFields {
    std::string size, crop, film, sensor, exposure_time, iso, observer;
    std::uint64_t samples = 0, light_splats = 0, light_paths = 0, dropped_aux = 0, faint = 0;
    std::uint64_t dropped_nan = 0, dropped_infinite = 0, dropped_negative_luminance = 0;
    std::string first_dropped;
    std::uint64_t clamped = 0;
    std::string removed_luminance;
    std::string scene, sampling, sample_ranges, partial_round;
};

/// Names of at most 31 characters, which old readers take.
/// Calls field(name, value) for each; Fields is FilmStateFields, const or not.
template <class Fields, class F>
void for_each_state_field(Fields& fields, const F& field) {
    field("emulsion.state.size", fields.size);      // "640x480", of the full frame
    field("emulsion.state.crop", fields.crop);      // "none", or "x0,y0,x1,y1"
    field("emulsion.state.film", fields.film);      // to_text(FilmOptions)
    field("emulsion.state.sensor", fields.sensor);  // to_text(SensorOptions)
    field("emulsion.state.exposureTime", fields.exposure_time);
    field("emulsion.state.iso", fields.iso);
    field("emulsion.state.observer", fields.observer);
    field("emulsion.state.samples", fields.samples);
    field("emulsion.state.lightSplats", fields.light_splats);
    field("emulsion.state.lightPaths", fields.light_paths);
    field("emulsion.state.droppedAux", fields.dropped_aux);
    field("emulsion.state.faint", fields.faint);
    field("emulsion.state.droppedNan", fields.dropped_nan);
    field("emulsion.state.droppedInfinite", fields.dropped_infinite);
    field("emulsion.state.droppedNegative", fields.dropped_negative_luminance);
    // Of each: pixel, kind by its number, then X, Y, Z and weight as the hexadecimal digits of their bits.
    field("emulsion.state.firstDropped", fields.first_dropped);
    field("emulsion.state.clamped", fields.clamped);
    field("emulsion.state.removedLuminance", fields.removed_luminance);  // the words of an ExactSum, in hexadecimal
    field("emulsion.state.scene", fields.scene);
    field("emulsion.state.sampling", fields.sampling);
    field("emulsion.state.sampleRanges", fields.sample_ranges);  // to_text(SampleRanges)
    // "none", or samples, side of a tile, number of tiles, and the tiles as hexadecimal digits of four, the first of
    // them in the highest bit.
    field("emulsion.state.partialRound", fields.partial_round);
}

[[nodiscard]] FilmStateFields fields_of(const FilmState& state);

/// The state without its pixels and its metadata. \throws std::invalid_argument if a field is no text of its kind.
[[nodiscard]] FilmState state_of(const FilmStateFields& fields);

}  // namespace emulsion
