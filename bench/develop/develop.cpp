// Developing 1, 8 and 33 megapixels with reinhard-global, from scene-referred XYZ in memory to code values in memory,
// beside a memory copy of the same picture, on one thread and on all. The memory
// that the codes take is new each time. Ratios are for one run on one machine.

#include "develop/develop.h"

#include <cstdint>
#include <vector>

#include <benchmark/benchmark.h>

#include "support/alternatives.h"
#include "support/tone_scene.h"

namespace emulsion {
namespace {

/// The stages after tone mapping: a pass from display-relative XYZ to 8 bits.
void after_tone_mapping(benchmark::State& state) {
    Pipeline pipeline;
    pipeline.dither = alternative_of_range<Dither>(state);
    const Image<XYZ>& scene = scene_of(state.range(1));
    const Image<XYZ> display = tone_map({}, scene.view(), kDisplayWhite, 0).image;
    for (auto _ : state) {
        benchmark::DoNotOptimize(develop_tone_mapped(display, pipeline, static_cast<int>(state.range(2))));
    }
    count_pixels(state, scene);
}

void whole(benchmark::State& state) {
    Pipeline pipeline;
    pipeline.dither = alternative_of_range<Dither>(state);
    const Image<XYZ>& scene = scene_of(state.range(1));
    const DevelopResult one_thread = develop(scene, pipeline, 1);
    for (auto _ : state) {
        const DevelopResult result = develop(scene, pipeline, static_cast<int>(state.range(2)));
        state.PauseTiming();
        if (result.image != one_thread.image) state.SkipWithError("differs from one thread's");
        state.ResumeTiming();
    }
    count_pixels(state, scene);
}

const std::vector<std::int64_t> kSizes = {1, 8, 33};
const std::vector<std::int64_t> kDithers = numbers_of<Dither>([](const Dither& dither) {
    return std::holds_alternative<NoDither>(dither) || std::holds_alternative<BlueNoise>(dither) ||
           std::holds_alternative<FloydSteinberg>(dither);
});

BENCHMARK(memory_copy)
    ->ArgNames({"megapixels", "threads"})
    ->ArgsProduct({kSizes, {1, 0}})
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(after_tone_mapping)
    ->ArgNames({"dither", "megapixels", "threads"})
    ->ArgsProduct({kDithers, kSizes, {1, 0}})
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(whole)
    ->ArgNames({"dither", "megapixels", "threads"})
    ->ArgsProduct({kDithers, kSizes, {1, 0}})
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace emulsion

BENCHMARK_MAIN();
