// Tone mapping of 1, 8 and 33 megapixels beside a memory copy of the same picture, on one thread and on all: the
// operators that adapt to the picture as a whole (local.cpp has the others). Each is verified against its
// double-precision twin before it is timed; ratios are for one run on one machine.

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "support/alternatives.h"
#include "support/tone_scene.h"
#include "tonemap/tone_mapper.h"

namespace emulsion {
namespace {

/// Empty if the fast path keeps to its tolerance.
std::string disagreement(const ToneMapper& mapper) {
    const Image<XYZ>& scene = scene_of(1);
    const Image<XYZ> fast = tone_map({mapper}, scene.view(), kDisplayWhite, 0).image;
    const XYZd white{kDisplayWhite.x, kDisplayWhite.y, kDisplayWhite.z};
    const Image<XYZd> exact = tone_map_reference({mapper}, scene.view(), white);
    for (std::size_t i = 0; i < fast.pixels().size(); ++i) {
        const double difference = std::abs(fast.pixels()[i].y - exact.pixels()[i].y);
        if (!(difference <= 2e-4 * exact.pixels()[i].y)) return "pixel " + std::to_string(i) + " is off its twin";
    }
    return {};
}

void statistics(benchmark::State& state) {
    const Image<XYZ>& scene = scene_of(state.range(0));
    for (auto _ : state) {
        benchmark::DoNotOptimize(luminance_statistics(scene.view(), static_cast<int>(state.range(1))));
    }
    count_pixels(state, scene);
}

void statistics_twin(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(luminance_statistics_reference(scene_of(1).view()));
    count_pixels(state, scene_of(1));
}

void tone_map_fast(benchmark::State& state) {
    const auto mapper = alternative_of_range<ToneMapper>(state);
    if (const std::string reason = disagreement(mapper); !reason.empty()) return state.SkipWithError(reason.c_str());
    const Image<XYZ>& scene = scene_of(state.range(1));
    Image<XYZ> display(scene.width(), scene.height());
    for (auto _ : state) {
        tone_map_into({mapper}, scene.view(), display.view(), kDisplayWhite, static_cast<int>(state.range(2)));
        benchmark::ClobberMemory();
    }
    count_pixels(state, scene);
}

void tone_map_twin(benchmark::State& state) {
    const auto mapper = alternative_of_range<ToneMapper>(state);
    const XYZd white{kDisplayWhite.x, kDisplayWhite.y, kDisplayWhite.z};
    for (auto _ : state) benchmark::DoNotOptimize(tone_map_reference({mapper}, scene_of(1).view(), white));
    count_pixels(state, scene_of(1));
}

const std::vector<std::int64_t> kSizes = {1, 8, 33};
const std::vector<std::int64_t> kOperators =
    numbers_of<ToneMapper>([](const ToneMapper& mapper) { return !is_local(own_adaptation(mapper)); });

BENCHMARK(memory_copy)
    ->ArgNames({"megapixels", "threads"})
    ->ArgsProduct({kSizes, {1, 0}})
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(statistics)
    ->ArgNames({"megapixels", "threads"})
    ->ArgsProduct({kSizes, {1, 0}})
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(statistics_twin)->Unit(benchmark::kMicrosecond);
BENCHMARK(tone_map_fast)
    ->ArgNames({"operator", "megapixels", "threads"})
    ->ArgsProduct({kOperators, kSizes, {1, 0}})
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(tone_map_twin)->ArgName("operator")->ArgsProduct({kOperators})->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace emulsion

BENCHMARK_MAIN();
