#include "pathtracer/render.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/parallel.h"
#include "film/filter_sampler.h"
#include "film/rgb_input.h"
#include "pathtracer/aux_layers.h"
#include "pathtracer/camera.h"
#include "pathtracer/path_integrator.h"
#include "pathtracer/sample_sequence.h"
#include "spectrum/wavelength_sampling.h"

namespace emulsion {

namespace {

/// Paths traced together: enough to fill Embree's packets down to the last bounces, few enough to stay in cache.
constexpr std::size_t kBatchSize = 256;

/// Renders tiles with one kind of transport.
template <class Transport>
class TileRenderer {
  public:
    TileRenderer(const PreparedScene& scene, const RenderOptions& options, const Film& film)
        : scene_(scene),
          options_(options),
          film_(film),
          is_splatted_(film.options().filter_use == FilterUse::splatted),
          sampler_(with_samples_per_pixel(scene.scene().sampler, options.samples_per_pixel)),
          filter_(film.options().filter),
          camera_(scene.scene().camera, film.options().width_px, film.options().height_px),
          aux_(scene.scene(), film.options().aux),
          rgb_input_(rgb_space("sRGB"), film.sensor().imaging_ratio()) {}

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
    static constexpr bool kSpectral = !std::is_same_v<Transport, RgbTransport>;

    struct Start {
        int x, y, sample_index;
        float x_px, y_px, weight;
    };

    Start start_path(int x, int y, int sample_index, Path<Transport>& path) const noexcept {
        path.samples = SampleSequence(sampler_, options_.seed, x, y, sample_index);
        const SampleJitter& jitter = scene_.scene().jitter;
        if constexpr (kSpectral) {
            const float wavelength = path.samples.next_1d();
            path.wavelengths =
                hero_wavelengths<Transport::kChannels>(wavelength_pdf_, jitter.wavelength ? wavelength : 0.5f);
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
        if constexpr (kSpectral) {
            if (is_splatted_) [[unlikely]]
                return add_at(tile, start.x_px, start.y_px, path);
            tile.add(start.x, start.y, path.wavelengths, path.radiance, start.weight);
        } else {
            const XYZ xyz = rgb_input_.to_xyz({path.radiance[0], path.radiance[1], path.radiance[2]});
            if (is_splatted_) return tile.add_at(start.x_px, start.y_px, xyz);
            tile.add(start.x, start.y, xyz, start.weight);
        }
    }
    void add_aux(FilmTile& tile, const Start& start, const FirstHit& hit) const noexcept {
        if (is_splatted_) return aux_.add_at(tile, start.x_px, start.y_px, hit);
        aux_.add(tile, start.x, start.y, start.weight, hit);
    }

    const PreparedScene& scene_;
    const RenderOptions& options_;
    const Film& film_;
    bool is_splatted_;
    Sampler sampler_;
    FilterSampler filter_;
    CameraRays camera_;
    AuxLayers aux_;
    VisibleWavelengthPdf wavelength_pdf_;
    RgbInput rgb_input_;
};

template <class Transport>
void render_with(const PreparedScene& scene, const RenderOptions& options, FilmInProgress& film,
                 RenderProgress& progress) {
    const TileRenderer<Transport> renderer(scene, options, film.film());
    const PixelBounds places = film.film().sample_bounds();
    while (const auto round = progress.stop ? std::nullopt : film.next_round(samples_of(options))) {
        parallel_for(0, static_cast<int>(round->tiles.size()), options.threads, [&](int i) {
            if (progress.stop.load(std::memory_order_relaxed)) return;
            const std::size_t tile = round->tiles[static_cast<std::size_t>(i)];
            const PixelBounds bounds = tile_bounds(places, round->tile_px, tile);
            film.merge(renderer.render_tile(bounds, round->samples), *round, tile);
            progress.samples_done += static_cast<std::int64_t>(bounds.width()) * bounds.height() *
                                     static_cast<std::int64_t>(round->samples.size());
        });
    }
}

void require_same(const char* what, const std::string& of_film, const std::string& of_render) {
    if (of_film == of_render) return;
    throw std::invalid_argument(std::string("film in progress: its ") + what + " is \"" + of_film + "\", expected \"" +
                                of_render + "\"");
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
    if (std::find(kWavelengthCounts.begin(), kWavelengthCounts.end(), options.wavelengths) == kWavelengthCounts.end()) {
        refuse("wavelengths", options.wavelengths, "1, 2, 4, 8, 16 or 32");
    }
    if (options.threads < 0) refuse("threads", options.threads, "at least 0");
}

SampleRange samples_of(const RenderOptions& options) noexcept {
    return options.samples.value_or(SampleRange{0, static_cast<std::uint64_t>(options.samples_per_pixel)});
}

FilmProvenance provenance_of(const Scene& scene, const RenderOptions& options) {
    FilmProvenance provenance;
    provenance.scene = scene.hash;
    provenance.sampling =
        to_text(with_samples_per_pixel(scene.sampler, options.samples_per_pixel)) +
        " seed=" + std::to_string(options.seed) +
        (options.transport == TransportKind::rgb ? " transport=rgb"
                                                 : " wavelengths=" + std::to_string(options.wavelengths)) +
        " renderer=emulsion-" EMULSION_VERSION;
    return provenance;
}

void render(const PreparedScene& scene, const RenderOptions& options, FilmInProgress& film, RenderProgress& progress) {
    validate(options);
    const FilmProvenance expected = provenance_of(scene.scene(), options), found = film.provenance();
    require_same("scene", found.scene, expected.scene);
    require_same("sampling", found.sampling, expected.sampling);
    if (options.transport == TransportKind::rgb) return render_with<RgbTransport>(scene, options, film, progress);
    switch (options.wavelengths) {
        case 1:
            return render_with<SpectralTransport<1>>(scene, options, film, progress);
        case 2:
            return render_with<SpectralTransport<2>>(scene, options, film, progress);
        case 4:
            return render_with<SpectralTransport<4>>(scene, options, film, progress);
        case 8:
            return render_with<SpectralTransport<8>>(scene, options, film, progress);
        case 16:
            return render_with<SpectralTransport<16>>(scene, options, film, progress);
        default:
            return render_with<SpectralTransport<32>>(scene, options, film, progress);
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
