// The bundled Cornell box at 512x512: samples per second, and which share of the time Embree takes, found by replaying
// the very same rays through Embree alone.

#include <chrono>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "pathtracer/prepared_scene.h"
#include "pathtracer/render.h"
#include "pathtracer/scene_parser.h"

namespace emulsion {
namespace {

constexpr int kSize_px = 512;
constexpr std::int64_t kPixels = std::int64_t{kSize_px} * kSize_px;

/// Independent sampler and box filter, so that the figures compare with other renderers.
PreparedScene& cornell_box() {
    static PreparedScene prepared = [] {
        Scene scene = read_scene(EMULSION_SOURCE_DIR "/scenes/cornell-box.pbrt");
        scene.film.width_px = scene.film.height_px = kSize_px;
        scene.sampler = IndependentSampler{};
        scene.filter = BoxFilter{};
        return PreparedScene(std::move(scene), 0);
    }();
    return prepared;
}

/// Renders once; the mean luminance tells that it was the picture.
double render_once(const RenderOptions& options) {
    Film film(film_options(cornell_box().scene()));
    RenderProgress progress;
    render(cornell_box(), options, film, progress);
    double sum = 0.0;
    const Image<XYZ> picture = film.xyz_image();
    for (const XYZ& pixel : picture.pixels()) sum += static_cast<double>(pixel.y);
    return sum / static_cast<double>(kPixels);
}

bool is_expected(double mean) {
    static const double expected = render_once({.samples_per_pixel = 64, .seed = 99});
    return std::abs(mean - expected) < 0.02 * expected;
}

/// Arguments: threads, wavelengths.
void render_cornell_box(benchmark::State& state) {
    const RenderOptions options{.samples_per_pixel = 16,
                                .seed = 1,
                                .wavelengths = static_cast<int>(state.range(1)),
                                .threads = static_cast<int>(state.range(0))};
    if (!is_expected(render_once(options))) state.SkipWithError("not the expected picture");
    for (auto _ : state) benchmark::DoNotOptimize(render_once(options));
    state.SetItemsProcessed(state.iterations() * kPixels * options.samples_per_pixel);
}

/// What is recorded and replayed: one sample per pixel on one thread.
constexpr RenderOptions kOneSample{.samples_per_pixel = 1, .seed = 1, .threads = 1};

RayLog record_rays() {
    RayLog log;
    cornell_box().accelerator().record(&log);
    render_once(kOneSample);
    cornell_box().accelerator().record(nullptr);
    return log;
}

void trace(const RayLog::Batch& batch, std::vector<Hit>& hits, std::vector<std::uint8_t>& occluded) {
    const Accelerator& accelerator = cornell_box().accelerator();
    if (batch.query == RayLog::Batch::Query::intersect) {
        hits.resize(batch.rays.size());
        accelerator.intersect(batch.rays, hits);
        benchmark::DoNotOptimize(hits.data());
    } else {
        occluded.resize(batch.rays.size());
        accelerator.occluded(batch.rays, occluded);
        benchmark::DoNotOptimize(occluded.data());
    }
}

double seconds_of(const auto& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// On one thread, in turn: the render, and its rays in the same batches through Embree alone. The ratio is of the sums.
void embree_share(benchmark::State& state) {
    const RayLog log = record_rays();
    std::vector<Hit> hits;
    std::vector<std::uint8_t> occluded;
    std::size_t rays = 0;
    for (const RayLog::Batch& batch : log.batches) rays += batch.rays.size();

    double render_s = 0.0, embree_s = 0.0;
    for (auto _ : state) {
        render_s += seconds_of([] { benchmark::DoNotOptimize(render_once(kOneSample)); });
        embree_s += seconds_of([&] {
            for (const RayLog::Batch& batch : log.batches) trace(batch, hits, occluded);
        });
    }
    const auto iterations = static_cast<double>(state.iterations());
    state.counters["embree_share"] = embree_s / render_s;
    state.counters["rays_per_path"] = static_cast<double>(rays) / static_cast<double>(kPixels);
    state.counters["samples_per_s"] = iterations * static_cast<double>(kPixels) / render_s;
    state.counters["rays_per_s"] = iterations * static_cast<double>(rays) / embree_s;
}

BENCHMARK(render_cornell_box)
    ->ArgNames({"threads", "wavelengths"})
    ->Args({1, 4})
    ->Args({2, 4})
    ->Args({1, 1})
    ->Args({1, 8})
    ->Args({1, 16})
    ->Args({1, 32})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK(embree_share)->Unit(benchmark::kMillisecond)->MinTime(5.0);

}  // namespace
}  // namespace emulsion

BENCHMARK_MAIN();
