#include "analysis/pilot.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/parallel.h"
#include "pathtracer/camera.h"
#include "pathtracer/path_integrator.h"
#include "pathtracer/render.h"
#include "pathtracer/sample_sequence.h"

namespace emulsion {

namespace {

void validate(const PilotOptions& options) {
    const auto refuse = [](const char* field, int value, const char* range) {
        throw std::invalid_argument(std::string("pilot: ") + field + " = " + std::to_string(value) + ": must be " +
                                    range);
    };
    if (options.pixels < 1) refuse("pixels", options.pixels, "at least 1");
    if (options.samples_per_pixel < 1) refuse("samples_per_pixel", options.samples_per_pixel, "at least 1");
    if (options.threads < 0) refuse("threads", options.threads, "at least 0");
}

/// Where the pilot's pixels lie in the film: an even grid over its crop.
struct PilotGrid {
    PixelBounds crop;
    int width_px = 1, height_px = 1;

    [[nodiscard]] std::pair<float, float> place(int x, int y, std::array<float, 2> u) const noexcept {
        const auto along = [](int begin, int size, int i, float within, int count) {
            return static_cast<float>(begin) +
                   static_cast<float>(size) * (static_cast<float>(i) + within) / static_cast<float>(count);
        };
        return {along(crop.x0, crop.width(), x, u[0], width_px), along(crop.y0, crop.height(), y, u[1], height_px)};
    }
};

PilotGrid grid_of(const Scene& scene, int pixels) {
    const FilmOptions film = film_options(scene);
    const PixelBounds crop = film.crop.value_or(PixelBounds{0, 0, film.width_px, film.height_px});
    const double side = std::sqrt(std::min(1.0, pixels / (static_cast<double>(crop.width()) * crop.height())));
    const auto scaled = [side](int size) { return std::max(1, static_cast<int>(std::lround(side * size))); };
    return {crop, scaled(crop.width()), scaled(crop.height())};
}

}  // namespace

Pilot trace_pilot(PreparedScene& scene, std::span<const TransportModel> models, const PilotOptions& options) {
    validate(options);
    Pilot pilot;
    pilot.channels = pilot_channels(scene.scene_spectra(), models);
    scene.prepare_for(pilot.channels.all);

    const PilotGrid grid = grid_of(scene.scene(), options.pixels);
    pilot.width_px = grid.width_px;
    pilot.height_px = grid.height_px;
    pilot.pixels.resize(static_cast<std::size_t>(grid.width_px) * static_cast<std::size_t>(grid.height_px));
    pilot.luminance_error.resize(pilot.pixels.size());
    const FilmSettings& film = scene.scene().film;
    const CameraRays camera(scene.scene().camera, film.width_px, film.height_px);
    const Sampler sampler = with_samples_per_pixel(scene.scene().sampler, options.samples_per_pixel);
    const auto samples = static_cast<std::size_t>(samples_per_pixel(sampler));
    const double scale = imaging_ratio(film.sensor) / static_cast<double>(samples);

    parallel_for(0, grid.height_px, options.threads, [&](int y) {
        PathIntegrator<PilotTransport> integrator(scene, scene.scene().integrator.max_depth);
        for (int x = 0; x < grid.width_px; ++x) {
            std::vector<Path<PilotTransport>> paths(samples);
            for (std::size_t i = 0; i < samples; ++i) {
                Path<PilotTransport>& path = paths[i];
                path.samples = SampleSequence(sampler, options.seed, x, y, static_cast<int>(i));
                const auto [x_px, y_px] = grid.place(x, y, path.samples.next_2d());
                path.ray = camera.has_lens() ? camera.ray(x_px, y_px, path.samples.next_2d()) : camera.ray(x_px, y_px);
            }
            integrator.trace(paths);
            const std::size_t pixel =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.width_px) + static_cast<std::size_t>(x);
            double squares = 0.0;
            for (const Path<PilotTransport>& path : paths) {
                ChannelValues values{};
                for (std::size_t k = 0; k < values.size(); ++k) {
                    values[k] = scale * static_cast<double>(path.radiance.value[k]);
                    pilot.pixels[pixel][k] += values[k];
                }
                const double y_of_path = xyz_of(pilot.channels, pilot.channels.bands, values).y;
                squares += y_of_path * y_of_path;
            }
            const auto n = static_cast<double>(samples);
            const double mean = xyz_of(pilot.channels, pilot.channels.bands, pilot.pixels[pixel]).y;
            // Of the sum of n samples, each already over n.
            const double variance = n > 1.0 ? std::max(0.0, squares - mean * mean / n) * n / (n - 1.0) : 0.0;
            pilot.luminance_error[pixel] = std::sqrt(variance);
        }
    });
    return pilot;
}

XYZd xyz_of(const PilotChannels& channels, const PilotChannels::Part& part, const ChannelValues& pixel) {
    XYZd sum{};
    for (std::size_t k = part.first; k < part.first + part.count; ++k) {
        const auto& [x, y, z] = channels.all[k].xyz;
        sum = sum + pixel[k] * XYZd{x, y, z};
    }
    return sum;
}

}  // namespace emulsion
