#include "pathtracer/render.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/parallel.h"
#include "core/parameters.h"
#include "core/random.h"
#include "film/filter_sampler.h"
#include "pathtracer/aux_layers.h"
#include "pathtracer/camera.h"
#include "pathtracer/path_integrator.h"
#include "pathtracer/sample_sequence.h"
#include "pathtracer/stopping_rule.h"
#include "spectrum/observer.h"
#include "spectrum/wavelength_sampler.h"

namespace emulsion {

namespace {

/// Paths traced together: enough to fill Embree's packets down to the last bounces, few enough to stay in cache.
constexpr std::size_t kBatchSize = 256;

WavelengthSampler sampler_of(const PreparedScene& scene, const TransportModel& model) {
    const auto* spectral = std::get_if<SpectralModel>(&model);
    const bool known = spectral != nullptr && !std::holds_alternative<HeroVisible>(spectral->strategy);
    return known ? scene.wavelengths() : WavelengthSampler{};
}

/// From a path's channels to what the film takes.
std::array<XYZ, kMostFixedChannels> channel_matrix(const FixedChannels& channels, double imaging_ratio) {
    std::array<XYZ, kMostFixedChannels> matrix{};
    for (std::size_t k = 0; k < channels.size(); ++k) {
        const auto& [x, y, z] = channels[k].xyz;
        matrix[k] = {static_cast<float>(x * imaging_ratio), static_cast<float>(y * imaging_ratio),
                     static_cast<float>(z * imaging_ratio)};
    }
    return matrix;
}

/// Where the random numbers of a picture come from.
struct RandomNumbers {
    Sampler sampler;
    std::uint64_t seed = 0;
};

/// Renders tiles with one kind of transport.
template <class Transport>
class TileRenderer {
  public:
    TileRenderer(const PreparedScene& scene, const TransportModel& model, const RandomNumbers& random, const Film& film)
        : scene_(scene),
          random_(random),
          film_(film),
          is_splatted_(film.options().filter_use == FilterUse::splatted),
          filter_(film.options().filter),
          camera_(scene.scene().camera, film.options().width_px, film.options().height_px),
          aux_(scene.scene(), film.options().aux),
          wavelengths_(sampler_of(scene, model)) {
        if constexpr (!Transport::kSpectral) {
            xyz_from_channels_ = channel_matrix(*scene.channels(), film.sensor().imaging_ratio());
        }
    }

    /// These samples of every pixel within the bounds, some of which may lie outside the frame.
    [[nodiscard]] FilmTile render_tile(PixelBounds bounds, SampleRange samples) const {
        FilmTile tile = film_.make_tile(bounds);
        PathIntegrator<Transport> integrator(scene_, scene_.scene().integrator.max_depth);
        std::vector<Start> starts;
        std::vector<Path<Transport>> paths;
        std::vector<FirstHit> first_hits(aux_.empty() ? 0 : kBatchSize);
        starts.reserve(kBatchSize);
        paths.reserve(kBatchSize);
        const auto finish_batch = [&] {
            const std::span<FirstHit> hits(first_hits.data(), aux_.empty() ? 0 : paths.size());
            integrator.trace(paths, hits);
            for (std::size_t i = 0; i < paths.size(); ++i) {
                add(tile, starts[i], paths[i]);
                if (!hits.empty()) [[unlikely]]
                    add_aux(tile, starts[i], hits[i]);
            }
            starts.clear();
            paths.clear();
        };
        const auto begin = static_cast<int>(samples.begin), end = static_cast<int>(samples.end);
        for (int y = bounds.y0; y < bounds.y1; ++y) {
            for (int x = bounds.x0; x < bounds.x1; ++x) {
                for (int i = begin; i < end; ++i) {
                    starts.push_back(start_path(x, y, i, paths.emplace_back()));
                    if (paths.size() == kBatchSize) finish_batch();
                }
            }
        }
        finish_batch();
        return tile;
    }

  private:
    struct Start {
        int x, y, sample_index;
        float x_px, y_px, weight;
    };

    Start start_path(int x, int y, int sample_index, Path<Transport>& path) const noexcept {
        path.samples = SampleSequence(random_.sampler, random_.seed, x, y, sample_index);
        const SampleJitter& jitter = scene_.scene().jitter;
        if constexpr (Transport::kSpectral) {
            const auto next_u = [&] {
                const float u = path.samples.next_1d();
                return jitter.wavelength ? u : 0.5f;
            };
            path.wavelengths = sample_wavelengths<Transport::kChannels>(wavelengths_, next_u);
            path.index = typename Transport::Index(path.wavelengths.lambda_nm);
        }
        const auto [u, v] = jittered(path.samples.next_2d());
        Start start{x, y, sample_index, static_cast<float>(x) + u, static_cast<float>(y) + v, 1.0f};
        if (!is_splatted_ && jitter.pixel) {
            const FilterSample place = filter_.sample(u, v);
            start.x_px = static_cast<float>(x) + 0.5f + place.x_offset_px;
            start.y_px = static_cast<float>(y) + 0.5f + place.y_offset_px;
            start.weight = place.weight;
        }
        path.ray = camera_.has_lens() ? camera_.ray(start.x_px, start.y_px, jittered(path.samples.next_2d()))
                                      : camera_.ray(start.x_px, start.y_px);
        return start;
    }

    [[nodiscard]] std::array<float, 2> jittered(const std::array<float, 2>& uv) const noexcept {
        return scene_.scene().jitter.pixel ? uv : std::array{0.5f, 0.5f};
    }

    void add(FilmTile& tile, const Start& start, const Path<Transport>& path) const noexcept {
        tile.set_sample_index(static_cast<std::uint64_t>(start.sample_index));
        if constexpr (Transport::kSpectral) {
            if (is_splatted_) [[unlikely]]
                return add_at(tile, start.x_px, start.y_px, path);
            tile.add(start.x, start.y, path.wavelengths, path.radiance, start.weight);
        } else {
            XYZ xyz{};
            for (int k = 0; k < Transport::kChannels; ++k) {
                xyz = xyz + path.radiance[k] * xyz_from_channels_[static_cast<std::size_t>(k)];
            }
            if (is_splatted_) return tile.add_at(start.x_px, start.y_px, xyz);
            tile.add(start.x, start.y, xyz, start.weight);
        }
    }
    void add_aux(FilmTile& tile, const Start& start, const FirstHit& hit) const noexcept {
        if (is_splatted_) return aux_.add_at(tile, start.x_px, start.y_px, hit);
        aux_.add(tile, start.x, start.y, start.weight, hit);
    }

    const PreparedScene& scene_;
    RandomNumbers random_;
    const Film& film_;
    bool is_splatted_;
    FilterSampler filter_;
    CameraRays camera_;
    AuxLayers aux_;
    WavelengthSampler wavelengths_;                            // of spectral models
    std::array<XYZ, kMostFixedChannels> xyz_from_channels_{};  // of the others
};

/// The noise pair of a picture, which follows it at a distance, and the rule that it is for.
template <class Transport>
class Stopping {
  public:
    Stopping(const PreparedScene& scene, const RenderOptions& options, const FilmOptions& film)
        : threads_(options.threads),
          rule_(film, *options.until, kTileSize_px),
          first_(scene, options.model, of_pair(options, 1), rule_.first()),
          second_(scene, options.model, of_pair(options, 2), rule_.second()) {}

    /// Looks at what has not been looked at yet, up to these samples of the picture; false if `stop` came before.
    bool follow(std::uint64_t picture_samples, const std::atomic<bool>& stop) {
        for (; next_look_ <= picture_samples; next_look_ = StoppingRule::look_after(next_look_)) {
            const std::uint64_t of_pair = StoppingRule::pair_samples(next_look_);
            trace_pair({pair_samples_, of_pair}, stop);
            if (stop.load(std::memory_order_relaxed)) return false;
            pair_samples_ = of_pair;
            rule_.look(next_look_, threads_);
        }
        return true;
    }

    [[nodiscard]] const std::vector<std::uint8_t>& stopped() const noexcept { return rule_.stopped(); }

  private:
    /// Independent ones: their differences are to tell the noise of samples, not of a sampler.
    static RandomNumbers of_pair(const RenderOptions& options, std::uint64_t member) {
        return {IndependentSampler{}, hash_combine(hash_combine(options.seed, 0x756e74696cu), member)};
    }

    void trace_pair(SampleRange samples, const std::atomic<bool>& stop) {
        if (samples.size() == 0) return;
        const std::vector<std::size_t> running = rule_.running_tiles();
        const PixelBounds& places = rule_.first().sample_bounds();
        parallel_for(0, static_cast<int>(running.size()), threads_, [&](int i) {
            if (stop.load(std::memory_order_relaxed)) return;
            const PixelBounds bounds = tile_bounds(places, kTileSize_px, running[static_cast<std::size_t>(i)]);
            rule_.first().merge(first_.render_tile(bounds, samples));
            rule_.second().merge(second_.render_tile(bounds, samples));
        });
    }

    int threads_;
    StoppingRule rule_;
    TileRenderer<Transport> first_, second_;
    std::uint64_t next_look_ = StoppingRule::kFirstLook, pair_samples_ = 0;
};

template <class Transport>
void render_round(const TileRenderer<Transport>& renderer, const RenderRound& round, int threads, FilmInProgress& film,
                  RenderProgress& progress) {
    const PixelBounds places = film.film().sample_bounds();
    parallel_for(0, static_cast<int>(round.tiles.size()), threads, [&](int i) {
        if (progress.stop.load(std::memory_order_relaxed)) return;
        const std::size_t tile = round.tiles[static_cast<std::size_t>(i)];
        const PixelBounds bounds = tile_bounds(places, round.tile_px, tile);
        film.merge(renderer.render_tile(bounds, round.samples), round, tile);
        progress.samples_done += static_cast<std::int64_t>(bounds.width()) * bounds.height() *
                                 static_cast<std::int64_t>(round.samples.size());
    });
}

template <class Transport>
void render_with(const PreparedScene& scene, const RenderOptions& options, FilmInProgress& film,
                 RenderProgress& progress) {
    const Sampler sampler = with_samples_per_pixel(scene.scene().sampler, options.samples_per_pixel);
    const TileRenderer<Transport> renderer(scene, options.model, {sampler, options.seed}, film.film());
    std::unique_ptr<Stopping<Transport>> stopping;
    if (options.until) stopping = std::make_unique<Stopping<Transport>>(scene, options, film.film().options());
    const SampleRange wanted = samples_of(options);
    while (!progress.stop) {
        if (stopping) {
            if (!stopping->follow(film.provenance().samples.count(), progress.stop)) return;
            const std::int64_t missing = film.missing_paths(wanted);
            film.leave_out(stopping->stopped());
            progress.samples_saved += missing - film.missing_paths(wanted);
        }
        const std::optional<RenderRound> round = film.next_round(wanted);
        if (!round) return;
        render_round(renderer, *round, options.threads, film, progress);
    }
}

void require_same(const char* what, const std::string& of_film, const std::string& of_render) {
    if (of_film == of_render) return;
    throw std::invalid_argument(std::string("film in progress: its ") + what + " is \"" + of_film + "\", expected \"" +
                                of_render + "\"");
}

void check_model(const PreparedScene& scene, const TransportModel& model, const FilmOptions& film) {
    if (!scene.is_prepared_for(model)) {
        throw std::invalid_argument("model: the scene is not prepared for " + to_text(model));
    }
    if (std::holds_alternative<SpectralModel>(model)) return;
    const std::string why = why_not_of_channels(film);
    if (!why.empty()) throw std::invalid_argument("model " + to_text(model) + ": " + why);
}

/// x0, x1, y0, y1 as parts of a frame, in whole pixels: as pbrt-v4 rounds them.
PixelBounds pixels_of(const std::array<double, 4>& window, int width_px, int height_px) noexcept {
    const auto pixels = [](double part, int size_px) { return static_cast<int>(std::ceil(part * size_px)); };
    return {pixels(window[0], width_px), pixels(window[2], height_px), pixels(window[1], width_px),
            pixels(window[3], height_px)};
}

}  // namespace

void validate(const RenderOptions& options) {
    const auto refuse = [](const std::string& field, auto value, const std::string& range) {
        throw std::invalid_argument(field + " " + std::to_string(value) + ": must be " + range);
    };
    if (options.samples_per_pixel < 1 || options.samples_per_pixel > kMostSamplesPerPixel) {
        refuse("samples_per_pixel", options.samples_per_pixel, "in [1, 16777216]");
    }
    const SampleRange samples = samples_of(options);
    if (samples.begin >= samples.end || samples.end > static_cast<std::uint64_t>(options.samples_per_pixel)) {
        throw std::invalid_argument("samples [" + std::to_string(samples.begin) + ", " + std::to_string(samples.end) +
                                    "): must be some of [0, " + std::to_string(options.samples_per_pixel) + ")");
    }
    validate(options.model);
    if (options.threads < 0) refuse("threads", options.threads, "at least 0");
    if (options.until && samples.size() < static_cast<std::uint64_t>(options.samples_per_pixel)) {
        throw std::invalid_argument("samples [" + std::to_string(samples.begin) + ", " + std::to_string(samples.end) +
                                    "): must be all where tiles stop on their own");
    }
}

std::string why_not_of_channels(const FilmOptions& film) {
    const SensorOptions& sensor = film.sensor;
    if (observer(sensor.observer).name != cie_1931_2deg().name) return "the film is of observer " + sensor.observer;
    if (sensor.camera) return "the film sees as a camera";
    if (sensor.white_balance) return "the film has a white balance";
    if (film.spectrum) return "the film has spectral buckets";
    return {};
}

SampleRange samples_of(const RenderOptions& options) noexcept {
    return options.samples.value_or(SampleRange{0, static_cast<std::uint64_t>(options.samples_per_pixel)});
}

FilmProvenance provenance_of(const Scene& scene, const RenderOptions& options) {
    FilmProvenance provenance;
    provenance.scene = scene.hash;
    provenance.sampling = to_text(with_samples_per_pixel(scene.sampler, options.samples_per_pixel)) +
                          " seed=" + std::to_string(options.seed) + " model=" + to_text(options.model);
    if (options.until) provenance.sampling += std::string(kStopsByTile) + number_text(*options.until);
    provenance.sampling += " renderer=emulsion-" EMULSION_VERSION;
    return provenance;
}

void render(const PreparedScene& scene, const RenderOptions& options, FilmInProgress& film, RenderProgress& progress) {
    validate(options);
    const FilmProvenance expected = provenance_of(scene.scene(), options), found = film.provenance();
    require_same("scene", found.scene, expected.scene);
    require_same("sampling", found.sampling, expected.sampling);
    check_model(scene, options.model, film.film().options());
    const auto render_as = [&]<class Transport>() { render_with<Transport>(scene, options, film, progress); };
    if (const auto* spectral = std::get_if<SpectralModel>(&options.model)) {
        for_each_wavelength_count([&]<int N>() {
            if (N == spectral->wavelengths) render_as.template operator()<SpectralTransport<N>>();
        });
        return;
    }
    switch (compiled_channels(static_cast<int>(scene.channels()->size()))) {
        case 3:
            return render_as.template operator()<FixedTransport<3>>();
        case 4:
            return render_as.template operator()<FixedTransport<4>>();
        default:  // a pilot is no model
            return render_as.template operator()<FixedTransport<8>>();
    }
}

void render(const PreparedScene& scene, const RenderOptions& options, Film& film, RenderProgress& progress) {
    validate(options);
    FilmInProgress in_progress(film, provenance_of(scene.scene(), options));
    render(scene, options, in_progress, progress);
}

FilmOptions film_options(const Scene& scene) {
    std::optional<PixelBounds> crop = scene.film.pixel_bounds;
    if (scene.film.crop_window) crop = pixels_of(*scene.film.crop_window, scene.film.width_px, scene.film.height_px);
    return {.width_px = scene.film.width_px,
            .height_px = scene.film.height_px,
            .sensor = scene.film.sensor,
            .crop = crop,
            .filter = scene.filter,
            .spectrum = scene.film.spectrum};
}

}  // namespace emulsion
