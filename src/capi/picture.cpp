// The C interface: what a film holds, as pixels and as files.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

#include "capi/emulsion.h"
#include "capi/handles.h"
#include "capi/sized_struct.h"
#include "capi/status.h"
#include "core/color.h"
#include "core/image.h"
#include "core/matrix3.h"
#include "core/named_value.h"
#include "film/exr_compression.h"
#include "film/exr_file.h"
#include "film/film.h"
#include "spectrum/rgb_space.h"

namespace {

using emulsion::Image;
using emulsion::XYZ;
using emulsion::capi::dereference;
using emulsion::capi::guarded;

/// \throws std::invalid_argument unless `length` is three numbers for each pixel of the film.
std::span<float> channels(float* numbers, std::size_t length, const emulsion::Film& film, const char* name) {
    const emulsion::PixelBounds bounds = film.bounds();
    const std::size_t expected =
        std::size_t{3} * static_cast<std::size_t>(bounds.width()) * static_cast<std::size_t>(bounds.height());
    dereference(numbers, name);
    if (length == expected) return {numbers, length};
    throw std::invalid_argument(std::string(name) + " has " + std::to_string(length) + " numbers, expected " +
                                std::to_string(expected));
}

emulsion_exr_options default_exr_options() {
    emulsion_exr_options options{};
    options.size = sizeof options;
    options.space = emulsion::kXyzSpaceName;
    options.pixel_type = EMULSION_FLOAT;
    options.compression = "zip";
    options.renderer_version = nullptr;
    return options;
}

/// The one place that knows the writer.
emulsion::ExrWriteResult write(const emulsion::Film& film, const char* path, const emulsion_exr_options& given) {
    const emulsion_exr_options from = emulsion::capi::complete(given, default_exr_options(), "EXR options");
    emulsion::ExrOptions options;
    options.space = &dereference(from.space, "EXR options: space");
    options.compression = emulsion::parse_named<emulsion::ExrCompression>(
        &dereference(from.compression, "EXR options: compression"), "compression");
    if (from.pixel_type != EMULSION_FLOAT && from.pixel_type != EMULSION_HALF) {
        throw std::invalid_argument("EXR options: pixel_type is " + std::to_string(from.pixel_type) +
                                    ", expected an emulsion_pixel_type");
    }
    options.pixel_type = from.pixel_type == EMULSION_HALF ? emulsion::PixelType::half : emulsion::PixelType::float32;
    options.white_luminance_cdm2 = white_luminance_cdm2(film.options().sensor);

    emulsion::FilmMetadata metadata;
    metadata.samples_per_pixel = static_cast<std::int64_t>(film.min_samples_per_pixel());
    metadata.sample_count = film.sample_count();
    const emulsion::DroppedSamples dropped = film.dropped();
    metadata.dropped_nan_count = dropped.count(emulsion::DroppedKind::nan);
    metadata.dropped_infinite_count = dropped.count(emulsion::DroppedKind::infinite);
    metadata.dropped_negative_luminance_count = dropped.count(emulsion::DroppedKind::negative_luminance);
    metadata.faint_count = film.counts().faint;
    metadata.filter = to_text(film.options().filter);
    if (from.renderer_version != nullptr) metadata.renderer_version = from.renderer_version;
    emulsion::FilmPicture picture;
    picture.xyz = film.xyz_image();
    picture.data_window = film.bounds();
    picture.width_px = film.options().width_px;
    picture.height_px = film.options().height_px;
    return write_exr(path, picture, metadata, options);
}

}  // namespace

emulsion_status emulsion_film_read_xyz(const emulsion_film* film, float* xyz, size_t length) {
    return guarded([&] {
        const emulsion::Film& from = dereference(film, "film").film;
        const std::span<float> to = channels(xyz, length, from, "xyz");
        const Image<XYZ> image = from.xyz_image();
        std::size_t i = 0;
        for (const XYZ& pixel : image.pixels()) {
            for (const float channel : {pixel.x, pixel.y, pixel.z}) to[i++] = channel;
        }
    });
}

emulsion_status emulsion_film_read_rgb(const emulsion_film* film, const char* space, float* rgb, size_t length) {
    return guarded([&] {
        const emulsion::Film& from = dereference(film, "film").film;
        const std::span<float> to = channels(rgb, length, from, "rgb");
        const emulsion::Matrix3 matrix = rgb_from_xyz(emulsion::rgb_space(&dereference(space, "space")));
        const Image<XYZ> image = from.xyz_image();
        std::size_t i = 0;
        for (const XYZ& pixel : image.pixels()) {
            const std::array<double, 3> xyz = {static_cast<double>(pixel.x), static_cast<double>(pixel.y),
                                               static_cast<double>(pixel.z)};
            for (const double channel : matrix* xyz) to[i++] = static_cast<float>(channel);
        }
    });
}

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
