// What transport models cost on the Cornell box: each against rgb, render by render in turn. The ratio is per sample;
// docs/transport-models.md charts it, and relative_cost() of src/analysis has it as numbers.

#include <string>

#include "scene_bench.h"

namespace emulsion::bench {
namespace {

void model_against_rgb(benchmark::State& state, const std::string& text) {
    SceneBench& scene = scene_of_file(EMULSION_SOURCE_DIR "/scenes/cornell-box.pbrt");
    const RenderOptions options{.samples_per_pixel = 1, .seed = 1, .model = parse_transport_model(text), .threads = 1};
    RenderOptions rgb = options;
    rgb.model = RgbModel{};
    scene.prepared().prepare_for(SpectralModel{});
    if (!scene.is_expected(scene.render_once({.samples_per_pixel = 16, .seed = 7}))) {
        state.SkipWithError("not the expected picture");
    }
    // Of alternating renders the median ratio: neighbours come and go.
    std::vector<double> ratios;
    double model_s = 0.0;
    for (auto _ : state) {
        scene.prepared().prepare_for(options.model);
        const double one = seconds_of([&] { benchmark::DoNotOptimize(scene.render_once(options)); });
        scene.prepared().prepare_for(rgb.model);
        ratios.push_back(one / seconds_of([&] { benchmark::DoNotOptimize(scene.render_once(rgb)); }));
        model_s += one;
    }
    std::sort(ratios.begin(), ratios.end());
    state.counters["times_rgb"] = ratios[ratios.size() / 2];
    state.counters["times_rgb_p25"] = ratios[ratios.size() / 4];
    state.counters["times_rgb_p75"] = ratios[ratios.size() * 3 / 4];
    state.counters["samples_per_s"] =
        static_cast<double>(state.iterations()) * static_cast<double>(scene.pixels()) / model_s;
}

[[maybe_unused]] const bool kRegistered = [] {
    for (const char* text : {"rgb-prefiltered", "basis:3", "basis:4", "basis:8", "spectral:1", "spectral:2",
                             "spectral:4", "spectral:4:hero-illuminant", "spectral:8", "spectral:16", "spectral:32"}) {
        benchmark::RegisterBenchmark(text, [text](benchmark::State& state) { model_against_rgb(state, text); })
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime()
            ->MinTime(4.0);
    }
    return true;
}();

}  // namespace
}  // namespace emulsion::bench

BENCHMARK_MAIN();
