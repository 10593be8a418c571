// The C interface: a film as a file.

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

#include "capi/emulsion.h"
#include "capi/handles.h"
#include "capi/sized_struct.h"
#include "capi/status.h"
#include "core/named_value.h"
#include "film/exr_compression.h"
#include "film/exr_file.h"
#include "film/film.h"
#include "film/film_layers.h"
#include "film/film_metadata.h"

namespace {

using emulsion::capi::dereference;
using emulsion::capi::guarded;

emulsion_exr_options default_exr_options() {
    emulsion_exr_options options{};
    options.size = sizeof options;
    options.space = emulsion::kXyzSpaceName;
    options.pixel_type = EMULSION_FLOAT;
    options.compression = "zip";
    options.renderer_version = nullptr;
    return options;
}

emulsion::PixelType pixel_type(std::int32_t number) {
    if (number == EMULSION_FLOAT) return emulsion::PixelType::float32;
    if (number == EMULSION_HALF) return emulsion::PixelType::half;
    throw std::invalid_argument("EXR options: pixel_type is " + std::to_string(number) +
                                ", expected an emulsion_pixel_type");
}

/// The one place that knows the writer.
emulsion::ExrWriteResult write(const emulsion::Film& film, const char* path, const emulsion_exr_options& given) {
    const emulsion_exr_options from = emulsion::capi::complete(given, default_exr_options(), "EXR options");
    emulsion::ExrOptions options;
    options.space = &dereference(from.space, "EXR options: space");
    options.compression = emulsion::parse_named<emulsion::ExrCompression>(
        &dereference(from.compression, "EXR options: compression"), "compression");
    options.pixel_type = pixel_type(from.pixel_type);
    options.white_luminance_cdm2 = white_luminance_cdm2(film.options().sensor);
    emulsion::FilmMetadata metadata;
    if (from.renderer_version != nullptr) metadata.renderer_version = from.renderer_version;

    // Others may merge: picture and header are of one moment.
    emulsion::FilmPicture picture;
    film.with_contents([&](const emulsion::FilmContents<emulsion::ExactSums>& contents) {
        picture = picture_of(contents, film.setup());
        metadata = metadata_of(contents, film.options(), {}, std::move(metadata));
    });
    return write_exr(path, picture, metadata, options);
}

}  // namespace

emulsion_status emulsion_exr_options_init(emulsion_exr_options* options, size_t size) {
    return guarded([&] {
        emulsion::capi::initialise(dereference(options, "options"), size, default_exr_options(), "EXR options");
    });
}

emulsion_status emulsion_film_write_exr(const emulsion_film* film, const char* path,
                                        const emulsion_exr_options* options, uint64_t* lost_values) {
    return guarded([&] {
        const emulsion::ExrWriteResult result = write(dereference(film, "film").film, &dereference(path, "path"),
                                                      options != nullptr ? *options : default_exr_options());
        if (lost_values == nullptr) return;
        *lost_values =
            static_cast<std::uint64_t>(result.too_high_count + result.too_low_count + result.vanished_positive_count +
                                       result.vanished_negative_count + result.non_finite_count);
    });
}
