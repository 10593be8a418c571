// Every bundled scene, and the reference scenes beside what pbrt-v4 made of them: samples per second on one thread and
// on two, and which share of the time Embree takes.

#include <algorithm>
#include <array>
#include <string_view>

#include "scene_bench.h"

namespace emulsion::bench {
namespace {

namespace fs = std::filesystem;

/// Samples per second of pbrt-v4 on one thread and on two of an idle machine (tests/data/reference/README.md).
struct PbrtSpeed {
    std::string_view scene;
    double one_thread, two_threads;
};
constexpr std::array kPbrt = {PbrtSpeed{"cornell-fl11", 267e3, 529e3},
                              PbrtSpeed{"cornell-published-light", 271e3, 539e3},
                              PbrtSpeed{"glass-dispersion", 510e3, 1003e3}, PbrtSpeed{"metals", 492e3, 969e3},
                              PbrtSpeed{"rgb-still-life", 642e3, 1261e3}};

/// One render on one thread, one on two, in turn, so that both see the same machine.
void render_scene(benchmark::State& state, const fs::path& file) {
    SceneBench& scene = scene_of_file(file);
    RenderOptions options{.samples_per_pixel = 8, .seed = 1, .threads = 1};
    if (!scene.is_expected(scene.render_once({.samples_per_pixel = 16, .seed = 5}))) {
        state.SkipWithError("not the expected picture");
    }
    double one_s = 0.0, two_s = 0.0, best_one_s = HUGE_VAL, best_two_s = HUGE_VAL;
    for (auto _ : state) {
        options.threads = 1;
        const double one = seconds_of([&] { benchmark::DoNotOptimize(scene.render_once(options)); });
        options.threads = 2;
        const double two = seconds_of([&] { benchmark::DoNotOptimize(scene.render_once(options)); });
        one_s += one;
        two_s += two;
        best_one_s = std::min(best_one_s, one);
        best_two_s = std::min(best_two_s, two);
    }
    const double samples = static_cast<double>(scene.pixels()) * options.samples_per_pixel;
    const double all = samples * static_cast<double>(state.iterations());
    state.counters["1_thread_samples_per_s"] = all / one_s;
    state.counters["2_threads_samples_per_s"] = all / two_s;
    state.counters["scaling"] = one_s / two_s;
    state.counters["best_scaling"] = best_one_s / best_two_s;
    for (const PbrtSpeed& pbrt : kPbrt) {
        if (file.parent_path().filename() != "reference" || file.stem() != pbrt.scene) continue;
        state.counters["times_pbrt_1_thread"] = samples / best_one_s / pbrt.one_thread;
        state.counters["times_pbrt_2_threads"] = samples / best_two_s / pbrt.two_threads;
    }
}

std::vector<fs::path> scene_files() {
    std::vector<fs::path> files;
    for (const fs::path folder : {EMULSION_SOURCE_DIR "/scenes", EMULSION_SOURCE_DIR "/tests/data/reference"}) {
        for (const auto& entry : fs::directory_iterator(folder)) {
            if (entry.path().extension() == ".pbrt") files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

[[maybe_unused]] const bool kRegistered = [] {
    for (const fs::path& file : scene_files()) {
        const std::string name = file.stem().string();
        benchmark::RegisterBenchmark(("render/" + name).c_str(),
                                     [file](benchmark::State& state) { render_scene(state, file); })
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime()
            ->MinTime(2.0);
        benchmark::RegisterBenchmark(
            ("embree_share/" + name).c_str(),
            [file](benchmark::State& state) { measure_embree_share(state, scene_of_file(file)); })
            ->Unit(benchmark::kMillisecond)
            ->MinTime(2.0);
    }
    return true;
}();

}  // namespace
}  // namespace emulsion::bench

BENCHMARK_MAIN();
