#pragma once
// The names of FilmMetadata's fields in a file's header, in one place for writing and reading. All are text: the
// format's own whole numbers have 32 bits.

#include <charconv>
#include <string>
#include <system_error>

#include "film/exr_file.h"

namespace emulsion {

/// Calls field(name, value) for each; Metadata is FilmMetadata, const or not.
template <class Metadata, class F>
void for_each_metadata_field(Metadata& metadata, const F& field) {
    field("emulsion.samplesPerPixel", metadata.samples_per_pixel);
    field("emulsion.sampleCount", metadata.sample_count);
    field("emulsion.droppedNanCount", metadata.dropped_nan_count);
    field("emulsion.droppedInfiniteCount", metadata.dropped_infinite_count);
    field("emulsion.droppedNegativeCount", metadata.dropped_negative_luminance_count);
    field("emulsion.faintCount", metadata.faint_count);
    field("emulsion.seed", metadata.seed);
    field("emulsion.rendererVersion", metadata.renderer_version);
    field("emulsion.commandLine", metadata.command_line);
    field("emulsion.model", metadata.model);
    field("emulsion.sampling", metadata.sampling);
    field("emulsion.pixels", metadata.pixels);
    field("emulsion.filter", metadata.filter);
    field("emulsion.film", metadata.film);
    field("emulsion.fireflyControl", metadata.firefly_control);
}

/// The exact buckets of the spectral channels, by rising wavelength: "centre:width centre:width ...", in nm.
inline constexpr const char* kSpectralBucketsAttribute = "emulsion.spectralBuckets";

/// Of a film state, in the part that holds its sums.
inline constexpr const char* kFilmStateVersionAttribute = "emulsion.filmStateVersion";

inline std::string attribute_text(const std::string& value) { return value; }
template <class Integer>
std::string attribute_text(Integer value) {
    return std::to_string(value);
}

/// False, and no change, if the text is no value of the field.
inline bool parse_attribute(const std::string& text, std::string& value) {
    value = text;
    return true;
}
template <class Integer>
bool parse_attribute(const std::string& text, Integer& value) {
    Integer parsed{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), parsed);
    if (error != std::errc{} || end != text.data() + text.size()) return false;
    value = parsed;
    return true;
}

}  // namespace emulsion
