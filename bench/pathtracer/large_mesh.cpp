// Large meshes: which share of the time Embree takes.

#include "pathtracer/landscape_scene.h"
#include "scene_bench.h"

namespace emulsion::bench {
namespace {

constexpr int kSide_px = 512;

/// Argument: triangles.
void embree_share(benchmark::State& state) {
    SceneBench scene(landscape_scene(state.range(0), kSide_px));
    if (!scene.is_expected(scene.render_once({.samples_per_pixel = 4, .seed = 5}))) {
        state.SkipWithError("not the expected picture");
    }
    measure_embree_share(state, scene);
}

BENCHMARK(embree_share)
    ->ArgName("triangles")
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->MinTime(4.0);

}  // namespace
}  // namespace emulsion::bench

BENCHMARK_MAIN();
