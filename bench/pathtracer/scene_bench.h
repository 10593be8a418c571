#pragma once
// A scene to render again and again, checked to be the same picture, and its rays to trace through Embree alone.

#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "film/film.h"
#include "pathtracer/prepared_scene.h"
#include "pathtracer/render.h"
#include "pathtracer/scene_parser.h"

namespace emulsion::bench {

inline double seconds_of(const auto& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Independent sampler and box filter, so that figures compare with other renderers'.
class SceneBench {
  public:
    explicit SceneBench(Scene scene) : prepared_(adapted(std::move(scene)), 0) {}

    [[nodiscard]] std::int64_t pixels() const {
        const FilmSettings& film = prepared_.scene().film;
        return std::int64_t{film.width_px} * film.height_px;
    }
    [[nodiscard]] PreparedScene& prepared() { return prepared_; }

    /// Renders once; the mean luminance tells that it was the picture.
    [[nodiscard]] double render_once(const RenderOptions& options) const {
        Film film(film_options(prepared_.scene()));
        RenderProgress progress;
        render(prepared_, options, film, progress);
        double sum = 0.0;
        const Image<XYZ> picture = film.xyz_image();
        for (const XYZ& pixel : picture.pixels()) sum += static_cast<double>(pixel.y);
        return sum / static_cast<double>(pixels());
    }

    /// Whether two spectral renders of other seeds agree to 5 %: caustics are noisy.
    [[nodiscard]] bool is_expected(double mean) const {
        const double expected = render_once({.samples_per_pixel = 16, .seed = 99});
        return std::abs(mean - expected) < 0.05 * expected;
    }

    /// The rays of one sample per pixel, on one thread, in their batches.
    [[nodiscard]] RayLog record_rays() {
        RayLog log;
        prepared_.accelerator().record(&log);
        benchmark::DoNotOptimize(render_once(kOneSample));
        prepared_.accelerator().record(nullptr);
        return log;
    }

    /// Traces a batch as the renderer did.
    void replay(const RayLog::Batch& batch) {
        if (batch.query == RayLog::Batch::Query::intersect) {
            hits_.resize(batch.rays.size());
            prepared_.accelerator().intersect(batch.rays, hits_);
            benchmark::DoNotOptimize(hits_.data());
        } else {
            occluded_.resize(batch.rays.size());
            prepared_.accelerator().occluded(batch.rays, occluded_);
            benchmark::DoNotOptimize(occluded_.data());
        }
    }

    static constexpr RenderOptions kOneSample{.samples_per_pixel = 1, .seed = 1, .threads = 1};

  private:
    static Scene adapted(Scene scene) {
        scene.sampler = IndependentSampler{};
        scene.filter = BoxFilter{};
        return scene;
    }

    PreparedScene prepared_;
    std::vector<Hit> hits_;
    std::vector<std::uint8_t> occluded_;
};

/// Read once, whichever benchmark asks first.
inline SceneBench& scene_of_file(const std::filesystem::path& file) {
    static std::map<std::filesystem::path, std::unique_ptr<SceneBench>> scenes;
    auto& scene = scenes[file];
    if (!scene) scene = std::make_unique<SceneBench>(read_scene(file));
    return *scene;
}

/// On one thread, in turn: renders, and their rays in the same batches through Embree alone. The ratio is of the sums.
inline void measure_embree_share(benchmark::State& state, SceneBench& scene) {
    const RayLog log = scene.record_rays();
    std::size_t rays = 0;
    for (const RayLog::Batch& batch : log.batches) rays += batch.rays.size();

    double render_s = 0.0, embree_s = 0.0;
    for (auto _ : state) {
        render_s += seconds_of([&] { benchmark::DoNotOptimize(scene.render_once(SceneBench::kOneSample)); });
        embree_s += seconds_of([&] {
            for (const RayLog::Batch& batch : log.batches) scene.replay(batch);
        });
    }
    const auto iterations = static_cast<double>(state.iterations()), pixels = static_cast<double>(scene.pixels());
    state.counters["embree_share"] = embree_s / render_s;
    state.counters["rays_per_path"] = static_cast<double>(rays) / pixels;
    state.counters["samples_per_s"] = iterations * pixels / render_s;
    state.counters["rays_per_s"] = iterations * static_cast<double>(rays) / embree_s;
}

}  // namespace emulsion::bench
