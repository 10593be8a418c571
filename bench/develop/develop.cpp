// Developing 1, 8 and 33 megapixels with reinhard-global, from scene-referred XYZ in memory to code values in memory,
// beside a memory copy of the same picture, on one thread and on all. The memory that the codes of a whole development
// take is new each time. Ratios are for one run on one machine.

#include "develop/develop.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <variant>
#include <vector>

#include <benchmark/benchmark.h>

#include "develop/picture_encoder.h"
#include "support/alternatives.h"
#include "support/tone_scene.h"

namespace emulsion {
namespace {

/// The stages after tone mapping: a pass from display-relative XYZ to 8 bits, into memory that was written before, as
/// the copy's was.
void after_tone_mapping(benchmark::State& state) {
    Pipeline pipeline;
    pipeline.dither = alternative_of_range<Dither>(state);
    const int threads = static_cast<int>(state.range(2));
    const Image<XYZ>& scene = scene_of(state.range(1));
    const Image<XYZ> display = tone_map({}, scene.view(), kDisplayWhite, 0).image;
    Image<CodeRGB> codes(scene.width(), scene.height());
    for (auto _ : state) {
        const auto read = [&](int y, int x0, std::span<XYZ> pixels) {
            std::ranges::copy(display.row(y).subspan(static_cast<std::size_t>(x0), pixels.size()), pixels.begin());
        };
        PictureEncoder encode(display.height(), read, pipeline);
        quantize_into(pipeline.dither, std::ref(encode), code_scale(8, FullRange{}), codes.view(), threads);
        benchmark::ClobberMemory();
    }
    if (codes != develop_tone_mapped(display, pipeline, 1).image) state.SkipWithError("differs from develop's");
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
