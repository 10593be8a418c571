// Solving for the spectrum of an RGB colour: the time of one solve, over random colours of a space.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/random.h"
#include "spectrum/rgb_uplift.h"

namespace emulsion {
namespace {

std::vector<RGBd> random_colours() {
    Pcg32 random(1);
    std::vector<RGBd> colours(256);
    for (RGBd& rgb : colours) rgb = {random.next_float(), random.next_float(), random.next_float()};
    return colours;
}

// What is timed must also be right: all of sRGB is reached.
bool all_reached(const RgbUplift& uplift, const std::vector<RGBd>& colours) {
    return std::all_of(colours.begin(), colours.end(), [&uplift](const RGBd& rgb) {
        const RGBd got = uplift.rgb_of(uplift.reflectance(rgb));
        return std::max({std::abs(got.r - rgb.r), std::abs(got.g - rgb.g), std::abs(got.b - rgb.b)}) <= 1e-9;
    });
}

void solve(benchmark::State& state, const char* space_name) {
    const RgbUplift uplift(rgb_space(space_name));
    const std::vector<RGBd> colours = random_colours();
    if (std::string_view(space_name) == "sRGB" && !all_reached(uplift, colours)) {
        state.SkipWithError("a colour of sRGB was not reached");
        return;
    }
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(uplift.reflectance(colours[i]));
        i = (i + 1) % colours.size();
    }
}

void prepare_space(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(RgbUplift(rgb_space("sRGB")));
}

BENCHMARK_CAPTURE(solve, srgb, "sRGB")->Unit(benchmark::kMicrosecond)->Repetitions(5);
BENCHMARK_CAPTURE(solve, rec2020, "Rec2020")->Unit(benchmark::kMicrosecond)->Repetitions(5);
BENCHMARK(prepare_space)->Unit(benchmark::kMicrosecond)->Repetitions(5);

}  // namespace
}  // namespace emulsion

BENCHMARK_MAIN();
