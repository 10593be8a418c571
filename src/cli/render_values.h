#pragma once
// What the values of `emulsion render`'s options mean. Each throws CLI::ValidationError naming the option, the text and
// what was expected.

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/render_settings.h"
#include "core/image.h"
#include "film/film_options.h"

namespace emulsion::cli {

/// Refuses an option's value as bad usage, if the library would refuse it.
template <class Options>
void check_option(const char* option, const Options& options) {
    try {
        validate(options);
    } catch (const std::invalid_argument& error) {
        throw CLI::ValidationError(option, error.what());
    }
}

/// "640x480"
[[nodiscard]] std::pair<int, int> parse_resolution(const std::string& text);
/// "16,8,48,24"
[[nodiscard]] PixelBounds parse_crop(const std::string& text);
/// "2/8"
[[nodiscard]] Shard parse_shard(const std::string& text);
/// "32" or "32:380-780"
[[nodiscard]] SpectralBuckets parse_spectrum(const std::string& text);
/// "albedo,normal"
[[nodiscard]] std::vector<AuxLayer> parse_aux(const std::string& text);
/// "luminance" or "xyz"
[[nodiscard]] FilmVariance parse_variance(const std::string& text);

}  // namespace emulsion::cli
