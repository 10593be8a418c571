#include "analysis/pilot.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "core/parallel.h"
#include "core/random.h"
#include "core/units.h"
#include "film/filter_sampler.h"
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

/// The film's pixels that the pilot has: one of each cell of an even grid.
struct PilotGrid {
    int film_width_px = 1, film_height_px = 1;
    int width_px = 1, height_px = 1;

    /// The left or upper edge of the one in this cell.
    [[nodiscard]] std::pair<int, int> place(int x, int y, std::uint64_t seed) const noexcept {
        Pcg32 random(hash_combine(hash_combine(seed, static_cast<std::uint64_t>(x)), static_cast<std::uint64_t>(y)));
        const auto within = [&random](int cell, int cells, int size) {
            const auto edge = [&](int i) { return static_cast<int>(static_cast<std::int64_t>(i) * size / cells); };
            const int begin = edge(cell), end = edge(cell + 1);
            return begin + static_cast<int>(random.next_float() * static_cast<float>(end - begin));
        };
        const int x_px = within(x, width_px, film_width_px);
        return {x_px, within(y, height_px, film_height_px)};
    }
};

PilotGrid grid_of(const FilmSettings& film, int pixels) {
    const double side = std::sqrt(std::min(1.0, pixels / (static_cast<double>(film.width_px) * film.height_px)));
    const auto scaled = [side](int size) { return std::max(1, static_cast<int>(std::lround(side * size))); };
    return {film.width_px, film.height_px, scaled(film.width_px), scaled(film.height_px)};
}

/// Paths of the pilot, pixel by pixel.
class PilotTracer {
  public:
    PilotTracer(const PreparedScene& scene, const PilotGrid& grid, const PilotOptions& options)
        : scene_(scene),
          grid_(grid),
          seed_(options.seed),
          sampler_(with_samples_per_pixel(scene.scene().sampler, options.samples_per_pixel)),
          filter_(scene.scene().filter),
          camera_(scene.scene().camera, grid.film_width_px, grid.film_height_px),
          integrator_(scene, scene.scene().integrator.max_depth),
          weights_(static_cast<std::size_t>(samples_per_pixel(sampler_))) {}

    /// One pixel into the pilot.
    void trace(int x, int y, Pilot& pilot) {
        const auto [x_px, y_px] = grid_.place(x, y, seed_);
        paths_.clear();
        paths_.resize(weights_.size());
        for (std::size_t i = 0; i < paths_.size(); ++i) weights_[i] = start(x_px, y_px, static_cast<int>(i), paths_[i]);
        integrator_.trace(paths_);

        const double weights = std::accumulate(weights_.begin(), weights_.end(), 0.0);
        if (!(weights > 0.0)) return;  // of the few samples of a filter with negative lobes
        const double scale = imaging_ratio(scene_.scene().film.sensor) / weights;
        const std::size_t pixel =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(grid_.width_px) + static_cast<std::size_t>(x);
        double squares = 0.0;
        for (std::size_t i = 0; i < paths_.size(); ++i) {
            ChannelValues values{};
            const double half = half_of(i);
            for (std::size_t k = 0; k < values.size(); ++k) {
                values[k] = scale * weights_[i] * static_cast<double>(paths_[i].radiance.value[k]);
                pilot.pixels[pixel][k] += values[k];
                pilot.noise[pixel][k] += half * values[k];
            }
            const double y_of_path = xyz_of(pilot.channels, pilot.channels.bands, values).y;
            squares += y_of_path * y_of_path;
        }
        const auto n = static_cast<double>(paths_.size());
        const double mean = xyz_of(pilot.channels, pilot.channels.bands, pilot.pixels[pixel]).y;
        // Of the sum of n samples, each already over n.
        const double variance = n > 1.0 ? std::max(0.0, squares - mean * mean / n) * n / (n - 1.0) : 0.0;
        pilot.luminance_error[pixel] = std::sqrt(variance);
    }

  private:
    /// 1 in the first half of the paths, -1 in the second, 0 in between.
    [[nodiscard]] double half_of(std::size_t path) const noexcept {
        const std::size_t half = paths_.size() / 2;
        return path < half ? 1.0 : path < paths_.size() - half ? 0.0 : -1.0;
    }

    /// \returns its weight.
    double start(int x_px, int y_px, int sample, Path<PilotTransport>& path) const {
        path.samples = SampleSequence(sampler_, seed_, x_px, y_px, sample);
        const auto [u, v] = path.samples.next_2d();
        const FilterSample place = filter_.sample(u, v);
        const float x = static_cast<float>(x_px) + 0.5f + place.x_offset_px;
        const float y = static_cast<float>(y_px) + 0.5f + place.y_offset_px;
        path.ray = camera_.has_lens() ? camera_.ray(x, y, path.samples.next_2d()) : camera_.ray(x, y);
        return static_cast<double>(place.weight);
    }

    const PreparedScene& scene_;
    const PilotGrid& grid_;
    std::uint64_t seed_;
    Sampler sampler_;
    FilterSampler filter_;
    CameraRays camera_;
    PathIntegrator<PilotTransport> integrator_;
    std::vector<Path<PilotTransport>> paths_;  // of one pixel
    std::vector<double> weights_;
};

}  // namespace

Pilot trace_pilot(PreparedScene& scene, std::span<const TransportModel> models, const PilotOptions& options) {
    validate(options);
    Pilot pilot;
    pilot.channels = pilot_channels(scene.scene_spectra(), models);
    scene.prepare_for(pilot.channels.all);

    const PilotGrid grid = grid_of(scene.scene().film, options.pixels);
    pilot.width_px = grid.width_px;
    pilot.height_px = grid.height_px;
    pilot.samples_per_pixel =
        samples_per_pixel(with_samples_per_pixel(scene.scene().sampler, options.samples_per_pixel));
    pilot.pixels.resize(static_cast<std::size_t>(grid.width_px) * static_cast<std::size_t>(grid.height_px));
    pilot.noise.resize(pilot.pixels.size());
    pilot.luminance_error.resize(pilot.pixels.size());
    parallel_for(0, grid.height_px, options.threads, [&](int y) {
        PilotTracer tracer(scene, grid, options);
        for (int x = 0; x < grid.width_px; ++x) tracer.trace(x, y, pilot);
    });
    return pilot;
}

std::vector<double> ratio_to_light(const PilotChannels& channels, const ChannelValues& pixel,
                                   std::span<const double> light) {
    static const std::vector<double> eye = eye_nodes();
    std::vector<double> ratio(light.size(), 0.0);
    std::size_t begin = 0;
    for (std::size_t band = 0; band < channels.bands.count; ++band) {
        const auto end = static_cast<std::size_t>(channels.band_end_nm[band] - kMinWavelength_nm);
        double seen = 0.0;
        for (std::size_t n = begin; n < end; ++n) seen += light[n] * eye[n];
        for (std::size_t n = begin; n < end && seen > 0.0; ++n) ratio[n] = pixel[channels.bands.first + band] / seen;
        begin = end;
    }
    return ratio;
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
