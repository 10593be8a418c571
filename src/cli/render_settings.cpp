#include "cli/render_settings.h"

#include <stdexcept>
#include <tuple>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/option_checks.h"
#include "film/camera_response.h"
#include "film/sensor_options.h"
#include "pathtracer/sample_sequence.h"

namespace emulsion::cli {

namespace {

/// What only the scene's frame can tell.
void require_inside(const PixelBounds& crop, const FilmSettings& film) {
    if (PixelBounds{0, 0, film.width_px, film.height_px}.contains(crop)) return;
    const std::string text = fmt::format("{},{},{},{}", crop.x0, crop.y0, crop.x1, crop.y1);
    const std::string frame = fmt::format("pixels inside the frame of {}x{}", film.width_px, film.height_px);
    throw CLI::ValidationError("--crop", found_expected(text, frame));
}

}  // namespace

SampleRange samples_of(const Shard& shard, int samples_per_pixel) noexcept {
    const auto samples = static_cast<std::uint64_t>(samples_per_pixel), count = static_cast<std::uint64_t>(shard.count);
    const auto number = static_cast<std::uint64_t>(shard.number);
    return {samples * (number - 1) / count, samples * number / count};
}

void apply(const RenderSettings& settings, Scene& scene) {
    if (settings.resolution_px) std::tie(scene.film.width_px, scene.film.height_px) = *settings.resolution_px;
    if (settings.crop) {
        require_inside(*settings.crop, scene.film);
        scene.film.crop_window.reset();
        scene.film.pixel_bounds = settings.crop;
    }
    if (settings.filter) scene.filter = *settings.filter;
    if (settings.spectrum) scene.film.spectrum = settings.spectrum;
    if (settings.observer) scene.film.sensor.observer = *settings.observer;
    if (settings.sensor) scene.film.sensor.camera = CameraSensor{read_camera_response(*settings.sensor)};
}

FilmOptions film_options(const RenderSettings& settings, const Scene& scene) {
    FilmOptions options = emulsion::film_options(scene);
    options.filter_use = settings.filter_use;
    options.variance = settings.variance;
    options.aux = settings.aux;
    options.firefly_control = settings.firefly_control;
    try {
        validate_clamp(options);  // the scene's exposure decides, too
    } catch (const std::invalid_argument& error) {
        throw CLI::ValidationError("--firefly", error.what());
    }
    return options;
}

RenderOptions render_options(const RenderSettings& settings, const Scene& scene) {
    RenderOptions options;
    options.samples_per_pixel = settings.samples_per_pixel.value_or(samples_per_pixel(scene.sampler));
    options.seed = settings.seed.value_or(static_cast<std::uint64_t>(scene.sampler_seed));
    if (const auto* model = std::get_if<TransportModel>(&settings.model)) options.model = *model;
    options.threads = settings.threads;
    options.until = settings.until;
    if (!settings.shard) return options;
    options.samples = samples_of(*settings.shard, options.samples_per_pixel);
    if (options.samples->size() > 0) return options;
    throw std::runtime_error(
        fmt::format("--shard {}/{}: this share of {} samples per pixel is empty, expected at most "
                    "as many shares as samples",
                    settings.shard->number, settings.shard->count, options.samples_per_pixel));
}

ExrOptions exr_options(const RenderSettings& settings, const Scene& scene) {
    ExrOptions options = exr_options(settings.exr, scene.film.pixel_type, settings.threads);
    options.white_luminance_cdm2 = white_luminance_cdm2(scene.film.sensor);
    return options;
}

}  // namespace emulsion::cli
