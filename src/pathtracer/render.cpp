#include "pathtracer/render.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/parallel.h"
#include "film/filter_sampler.h"
#include "pathtracer/camera.h"
#include "pathtracer/path_integrator.h"
#include "spectrum/wavelength_sampling.h"

namespace emulsion {

namespace {

/// Neither shows in the picture: the film's sums are exact.
constexpr int kTileSize_px = 16;
constexpr int kSamplesPerRound = 16;

/// The first rounds are of 1, 1, 2, 4 and 8 samples, so that a picture is soon whole, if noisy.
constexpr int round_end(int begin) noexcept { return begin + std::clamp(begin, 1, kSamplesPerRound); }

/// Paths traced together: enough to fill Embree's packets down to the last bounces, few enough to stay in cache.
constexpr std::size_t kBatchSize = 256;

/// Renders rounds of tiles with N wavelengths per path.
template <int N>
class TileRenderer {
  public:
    TileRenderer(const PreparedScene& scene, const RenderOptions& options, Film& film)
        : scene_(scene),
          options_(options),
          film_(film),
          sampler_(with_samples_per_pixel(scene.scene().sampler, options.samples_per_pixel)),
          filter_(film.options().filter),
          camera_(scene.scene().camera, film.options().width_px, film.options().height_px) {}

    /// Samples [begin, end) of every pixel within the bounds.
    void render_tile(PixelBounds bounds, int begin, int end) const {
        FilmTile tile = film_.make_tile(bounds);
        PathIntegrator<N> integrator(scene_, scene_.scene().integrator.max_depth);
        std::vector<Start> starts;
        std::vector<Path<N>> paths;
        starts.reserve(kBatchSize);
        paths.reserve(kBatchSize);
        const auto finish_batch = [&] {
            integrator.trace(paths);
            for (std::size_t i = 0; i < paths.size(); ++i) {
                tile.add(starts[i].x, starts[i].y, paths[i].wavelengths, paths[i].radiance, starts[i].weight);
            }
            starts.clear();
            paths.clear();
        };
        for (int y = bounds.y0; y < bounds.y1; ++y) {
            for (int x = bounds.x0; x < bounds.x1; ++x) {
                for (int i = begin; i < end; ++i) {
                    starts.push_back(start_path(x, y, i, paths.emplace_back()));
                    if (paths.size() == kBatchSize) finish_batch();
                }
            }
        }
        finish_batch();
        film_.merge(tile);
    }

  private:
    struct Start {
        int x, y;
        float weight;
    };

    Start start_path(int x, int y, int sample_index, Path<N>& path) const noexcept {
        path.samples = SampleSequence(sampler_, options_.seed, x, y, sample_index);
        path.wavelengths = hero_wavelengths<N>(wavelength_pdf_, path.samples.next_1d());
        path.index = SpectrumTableIndex<N>(path.wavelengths.lambda_nm);
        const auto [u, v] = path.samples.next_2d();
        const FilterSample place = filter_.sample(u, v);
        path.ray = camera_.ray(static_cast<float>(x) + 0.5f + place.x_offset_px,
                               static_cast<float>(y) + 0.5f + place.y_offset_px);
        return {x, y, place.weight};
    }

    const PreparedScene& scene_;
    const RenderOptions& options_;
    Film& film_;
    Sampler sampler_;
    FilterSampler filter_;
    CameraRays camera_;
    VisibleWavelengthPdf wavelength_pdf_;
};

template <int N>
void render_with(const PreparedScene& scene, const RenderOptions& options, Film& film, RenderProgress& progress) {
    const TileRenderer<N> renderer(scene, options, film);
    const int width = film.options().width_px, height = film.options().height_px;
    const int columns = (width + kTileSize_px - 1) / kTileSize_px, rows = (height + kTileSize_px - 1) / kTileSize_px;
    int end = 0;
    for (int begin = 0; begin < options.samples_per_pixel && !progress.stop; begin = end) {
        end = std::min(round_end(begin), options.samples_per_pixel);
        parallel_for(0, columns * rows, options.threads, [&](int i) {
            if (progress.stop.load(std::memory_order_relaxed)) return;
            const int x = (i % columns) * kTileSize_px, y = (i / columns) * kTileSize_px;
            const PixelBounds bounds{x, y, std::min(x + kTileSize_px, width), std::min(y + kTileSize_px, height)};
            renderer.render_tile(bounds, begin, end);
            progress.samples_done += static_cast<std::int64_t>(bounds.width()) * bounds.height() * (end - begin);
        });
    }
}

}  // namespace

void validate(const RenderOptions& options) {
    const auto refuse = [](const std::string& field, auto value, const std::string& range) {
        throw std::invalid_argument(field + " " + std::to_string(value) + ": must be " + range);
    };
    if (options.samples_per_pixel < 1 || options.samples_per_pixel > (1 << 24)) {
        refuse("samples_per_pixel", options.samples_per_pixel, "in [1, 16777216]");
    }
    if (std::find(kWavelengthCounts.begin(), kWavelengthCounts.end(), options.wavelengths) == kWavelengthCounts.end()) {
        refuse("wavelengths", options.wavelengths, "1, 2, 4, 8, 16 or 32");
    }
    if (options.threads < 0) refuse("threads", options.threads, "at least 0");
}

void render(const PreparedScene& scene, const RenderOptions& options, Film& film, RenderProgress& progress) {
    validate(options);
    switch (options.wavelengths) {
        case 1:
            return render_with<1>(scene, options, film, progress);
        case 2:
            return render_with<2>(scene, options, film, progress);
        case 4:
            return render_with<4>(scene, options, film, progress);
        case 8:
            return render_with<8>(scene, options, film, progress);
        case 16:
            return render_with<16>(scene, options, film, progress);
        default:
            return render_with<32>(scene, options, film, progress);
    }
}

FilmOptions film_options(const Scene& scene) {
    return {.width_px = scene.film.width_px,
            .height_px = scene.film.height_px,
            .sensor = scene.film.sensor,
            .filter = scene.filter};
}

}  // namespace emulsion
