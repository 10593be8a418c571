// What wavelengths cost on the Cornell box: N of them per path against red, green and blue, render by render in turn.
// The ratio is per sample; docs/path-tracer.md charts it.

#include "scene_bench.h"

namespace emulsion::bench {
namespace {

/// Argument: N.
void wavelengths_against_rgb(benchmark::State& state) {
    SceneBench& scene = scene_of_file(EMULSION_SOURCE_DIR "/scenes/cornell-box.pbrt");
    const RenderOptions spectral{
        .samples_per_pixel = 1, .seed = 1, .model = SpectralModel{static_cast<int>(state.range(0))}, .threads = 1};
    RenderOptions rgb = spectral;
    rgb.model = RgbModel{};
    scene.prepared().prepare_for(rgb.model);
    if (!scene.is_expected(scene.render_once({.samples_per_pixel = 16, .seed = 7}))) {
        state.SkipWithError("not the expected picture");
    }
    // Of alternating renders the median ratio: neighbours come and go.
    std::vector<double> ratios;
    double spectral_s = 0.0;
    for (auto _ : state) {
        const double one = seconds_of([&] { benchmark::DoNotOptimize(scene.render_once(spectral)); });
        ratios.push_back(one / seconds_of([&] { benchmark::DoNotOptimize(scene.render_once(rgb)); }));
        spectral_s += one;
    }
    std::sort(ratios.begin(), ratios.end());
    state.counters["times_rgb"] = ratios[ratios.size() / 2];
    state.counters["times_rgb_p25"] = ratios[ratios.size() / 4];
    state.counters["times_rgb_p75"] = ratios[ratios.size() * 3 / 4];
    state.counters["samples_per_s"] = static_cast<double>(state.iterations()) * static_cast<double>(scene.pixels()) *
                                      spectral.samples_per_pixel / spectral_s;
}

BENCHMARK(wavelengths_against_rgb)
    ->ArgName("wavelengths")
    ->RangeMultiplier(2)
    ->Range(1, 32)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MinTime(4.0);

}  // namespace
}  // namespace emulsion::bench

BENCHMARK_MAIN();
