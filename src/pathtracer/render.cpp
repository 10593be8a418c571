#include "pathtracer/render.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/parallel.h"
#include "core/parameters.h"
#include "core/random.h"
#include "pathtracer/sample_sequence.h"
#include "pathtracer/stopping_rule.h"
#include "pathtracer/tile_renderer.h"
#include "spectrum/observer.h"

namespace emulsion {

namespace {

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
