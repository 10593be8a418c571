// Local operators on pictures of 1, 8 and 33 megapixels beside a memory copy of the same picture, on one thread and on
// all; and their adaptations alone. Each operator is verified against its double-precision twin on a small picture
// before it is timed; ratios are for one run on one machine.

#include <algorithm>
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

/// Empty if displayed luminances are off the twin's by less than 1 % of display white on average. Colour differences,
/// which the tolerance is stated in, are left to tests/develop.
std::string disagreement(const ToneMapping& mapping) {
    const Image<XYZ> scene = make_scene(192, 128);
    const Image<XYZ> fast = tone_map(mapping, scene.view(), kDisplayWhite, 0).image;
    const Image<XYZd> exact =
        tone_map_reference(mapping, scene.view(), {kDisplayWhite.x, kDisplayWhite.y, kDisplayWhite.z});
    double sum = 0.0;
    for (std::size_t i = 0; i < fast.pixels().size(); ++i) {
        sum += std::abs(std::min(double{fast.pixels()[i].y}, 1.0) - std::min(exact.pixels()[i].y, 1.0));
    }
    const double mean = sum / static_cast<double>(fast.pixels().size());
    return mean < 0.01 ? std::string() : "off its twin by " + std::to_string(mean) + " on average";
}

void tone_map_fast(benchmark::State& state) {
    const auto mapper = alternative_of_range<ToneMapper>(state);
    if (const std::string reason = disagreement({mapper}); !reason.empty()) return state.SkipWithError(reason.c_str());
    const Image<XYZ>& scene = scene_of(state.range(1));
    Image<XYZ> display(scene.width(), scene.height());
    for (auto _ : state) {
        tone_map_into({mapper}, scene.view(), display.view(), kDisplayWhite, static_cast<int>(state.range(2)));
        benchmark::ClobberMemory();
    }
    count_pixels(state, scene);
}

/// Of a picture so small that every pixel of a bilateral window can be looked at.
void tone_map_twin(benchmark::State& state) {
    const auto mapper = alternative_of_range<ToneMapper>(state);
    const Image<XYZ> scene = make_scene(192, 128);
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            tone_map_reference({mapper}, scene.view(), {kDisplayWhite.x, kDisplayWhite.y, kDisplayWhite.z}));
    }
    count_pixels(state, scene);
}

/// The adaptation alone, on 8 megapixels.
void adaptation(benchmark::State& state) {
    const auto chosen = alternative_of_range<Adaptation>(state);
    const Image<XYZ>& scene = scene_of(8);
    const SceneLuminance luminance = SceneLuminance(scene.view(), 0);
    for (auto _ : state) {
        benchmark::DoNotOptimize(adapt(chosen, scene.view(), luminance, static_cast<int>(state.range(1))));
    }
    count_pixels(state, scene);
}

const std::vector<std::int64_t> kSizes = {1, 8, 33};
const std::vector<std::int64_t> kOperators =
    numbers_of<ToneMapper>([](const ToneMapper& mapper) { return is_local(own_adaptation(mapper)); });
const std::vector<std::int64_t> kAdaptations =
    numbers_of<Adaptation>([](const Adaptation& chosen) { return is_local(chosen); });

BENCHMARK(memory_copy)
    ->ArgNames({"megapixels", "threads"})
    ->ArgsProduct({kSizes, {1, 0}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(tone_map_fast)
    ->ArgNames({"operator", "megapixels", "threads"})
    ->ArgsProduct({kOperators, kSizes, {1, 0}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(tone_map_twin)->ArgName("operator")->ArgsProduct({kOperators})->Unit(benchmark::kMillisecond);
BENCHMARK(adaptation)
    ->ArgNames({"adaptation", "threads"})
    ->ArgsProduct({kAdaptations, {1, 0}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace emulsion

BENCHMARK_MAIN();
