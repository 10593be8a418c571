// Bloom and vision at 1, 4 and 16 megapixels, on one thread and on all: cost grows with the number of pixels. Each is
// verified against its double-precision twin on a small picture before it is timed. `direct` is bloom by direct sums,
// in pixels of a small picture; its cost for each pixel grows with the kernel's area. CPU time is of the calling
// thread.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include <benchmark/benchmark.h>

#include "core/random.h"
#include "tonemap/bloom.h"
#include "tonemap/vision.h"

namespace emulsion {
namespace {

/// Luminances spread over six decades.
Image<XYZ> random_scene(int width, int height) {
    Pcg32 random(1);
    Image<XYZ> scene(width, height);
    for (XYZ& p : scene.pixels()) {
        const float luminance = std::pow(10.0f, 6.0f * random.next_float() - 3.0f);
        p = {luminance * 2.0f * random.next_float(), luminance, luminance * 2.0f * random.next_float()};
    }
    return scene;
}

/// Half of the light that the fast kernel puts elsewhere than the twin's.
double misplaced_share() {
    Image<XYZ> scene(61, 53);
    scene(30, 26) = {1.0f, 1.0f, 1.0f};
    const Image<XYZ> fast = add_bloom(QuarticBloom{0.4f, 1.0f}, scene.view(), 0);
    const Image<XYZd> exact = add_bloom_reference(QuarticBloom{0.4f, 1.0f}, scene.view());
    double sum = 0.0;
    for (std::size_t i = 0; i < fast.pixels().size(); ++i) {
        sum += 0.5 * std::abs(fast.pixels()[i].y - exact.pixels()[i].y);
    }
    return sum;
}

void count_pixels(benchmark::State& state, const Image<XYZ>& scene) {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(scene.pixels().size()));
}

void bloom(benchmark::State& state) {
    if (misplaced_share() > 0.02) state.SkipWithError("the kernel is off its twin's");
    const int side = static_cast<int>(state.range(0));
    const Image<XYZ> scene = random_scene(side, side);
    const QuarticBloom chosen{static_cast<float>(state.range(1)) / 1000.0f, 0.1f};
    for (auto _ : state) {
        benchmark::DoNotOptimize(add_bloom(chosen, scene.view(), static_cast<int>(state.range(2))));
    }
    count_pixels(state, scene);
}

void vision(benchmark::State& state) {
    const int side = static_cast<int>(state.range(0));
    const Image<XYZ> scene = random_scene(side, side);
    for (auto _ : state) {
        benchmark::DoNotOptimize(see(HumanVision{}, scene.view(), static_cast<int>(state.range(1))));
    }
    count_pixels(state, scene);
}

void direct(benchmark::State& state) {
    const Image<XYZ> scene = random_scene(64, 64);
    for (auto _ : state) benchmark::DoNotOptimize(add_bloom_reference(QuarticBloom{}, scene.view()));
    count_pixels(state, scene);
}

BENCHMARK(bloom)
    ->ArgNames({"side_px", "radius_per_mille", "threads"})
    ->ArgsProduct({{1024, 2048, 4096}, {10, 100}, {1, 0}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(vision)
    ->ArgNames({"side_px", "threads"})
    ->ArgsProduct({{1024, 2048, 4096}, {1, 0}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(direct)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace emulsion

BENCHMARK_MAIN();
