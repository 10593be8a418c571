#include "cli/film_files.h"

#include <string>

#include "cli/file_names.h"
#include "cli/loss_warnings.h"
#include "cli/messages.h"
#include "compare/pixel_choice.h"
#include "film/film_layers.h"
#include "film/film_metadata.h"
#include "spectrum/observer.h"

namespace emulsion::cli {

namespace {

/// Warns of what the file could not hold, and gives back what it does.
Image<XYZ> picture_in_file(const std::filesystem::path& output, const Image<XYZ>& picture,
                           const ExrWriteResult& written, const ExrOptions& options) {
    for (const std::string& loss : exr_losses(written, options.pixel_type)) {
        print_warning(output.string() + ": " + loss);
    }
    if (!is_lossy(options.compression)) return as_stored(picture, options);
    return read_exr(output, {.layers = ExrLayers::skip, .threads = options.threads}).xyz;
}

/// Half or float, into options and header; says so.
void decide(const AutoPixelType& pixels, const std::filesystem::path& output, const FilmPicture& picture,
            const SensorOptions& sensor, ExrOptions& options, FilmMetadata& metadata) {
    if (!pixels.budget) return;
    PixelDecision decision{PixelType::float32, "float: the exact sums of a film state are most of it"};
    if (!is_state_name(output)) {
        decision = decide_pixels(half_loss(picture, options, observer(sensor.observer)), *pixels.budget);
        metadata.pixels = decision.reason;
    }
    options.pixel_type = decision.type;
    if (!pixels.quiet) print_output(decision.reason + "\n");
}

}  // namespace

FilmState state_of(const FilmInProgress& film, const FilmMetadata& run) {
    return film.read([&](const Film& contents, const FilmProvenance& provenance) {
        return emulsion::state_of(contents, provenance, run);
    });
}

Image<XYZ> write_film(const std::filesystem::path& output, const FilmInProgress& film, FilmMetadata run,
                      ExrOptions options, const AutoPixelType& pixels) {
    const FilmPicture picture = picture_of(film.film());
    decide(pixels, output, picture, film.film().options().sensor, options, run);
    const ExrWriteResult written =
        is_state_name(output) ? write_film_state(output, state_of(film, run), options)
                              : write_exr(output, picture, metadata_of(film.film(), film.provenance(), run), options);
    return picture_in_file(output, picture.xyz, written, options);
}

Image<XYZ> write_film(const std::filesystem::path& output, const FilmState& state, ExrOptions options,
                      const AutoPixelType& pixels) {
    options.white_luminance_cdm2 = white_luminance_cdm2(state.options.sensor);
    const FilmPicture picture = picture_of(state.contents, FilmSetup(state.options));
    FilmMetadata metadata = state.metadata;
    decide(pixels, output, picture, state.options.sensor, options, metadata);
    const ExrWriteResult written = is_state_name(output) ? write_film_state(output, state, options)
                                                         : write_exr(output, picture, metadata, options);
    return picture_in_file(output, picture.xyz, written, options);
}

}  // namespace emulsion::cli
