// What a large mesh takes to be rendered, beside what Embree alone needs for it.

#include <atomic>
#include <fstream>

#include <malloc.h>

#include "pathtracer/embree.h"
#include "pathtracer/landscape_scene.h"
#include "scene_bench.h"

namespace emulsion::bench {
namespace {

constexpr int kSide_px = 512;

/// A line of /proc/self/status, e.g. VmHWM: the most memory that was resident since forget_peak().
double resident_bytes(const std::string& line) {
    std::ifstream status("/proc/self/status");
    for (std::string name; status >> name;) {
        double kib = 0.0;
        if (name == line + ":" && status >> kib) return kib * 1024.0;
        status.clear();
    }
    return NAN;
}

void forget_peak() {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";
}

/// Adds up what a device of Embree allocates and frees.
bool count_bytes(void* total, ssize_t bytes, bool /*after*/) {
    *static_cast<std::atomic<std::int64_t>*>(total) += bytes;
    return true;
}

struct BareHierarchy {
    double reported = 0.0, resident = 0.0;  // bytes, once it is built
};

/// Embree's compact hierarchy over a mesh, and nothing else.
BareHierarchy build_bare(const TriangleMesh& mesh) {
    malloc_trim(0);
    const double before = resident_bytes("VmRSS");
    std::atomic<std::int64_t> reported{0};
    RTCDevice device = rtcNewDevice(nullptr);
    rtcSetDeviceMemoryMonitorFunction(device, count_bytes, &reported);
    RTCScene scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_COMPACT | RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh.position.data(), 0,
                               sizeof(mesh.position[0]), mesh.position.size());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangle.data(), 0,
                               sizeof(mesh.triangle[0]), mesh.triangle.size());
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    const BareHierarchy bare{static_cast<double>(reported), resident_bytes("VmRSS") - before};
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
    return bare;
}

/// Argument: triangles. Ratios are of the peak, from an empty process to the rendered picture, to vertices, indices and
/// hierarchy; of the latter Embree reports what it reserves, of which not every page is used.
void memory_of_render(benchmark::State& state) {
    for (auto _ : state) {
        forget_peak();
        const double before = resident_bytes("VmRSS");
        SceneBench scene(landscape_scene(state.range(0), kSide_px));
        benchmark::DoNotOptimize(scene.render_once({.samples_per_pixel = 1, .seed = 1}));
        const double peak = resident_bytes("VmHWM") - before;

        const auto& mesh = std::get<TriangleMesh>(scene.prepared().scene().shapes[0].geometry);
        const auto vertices = static_cast<double>(mesh.position.size() * sizeof(mesh.position[0]) +
                                                  mesh.triangle.size() * sizeof(mesh.triangle[0]));
        const BareHierarchy bare = build_bare(mesh);
        state.counters["peak_MB"] = peak * 1e-6;
        state.counters["vertices_MB"] = vertices * 1e-6;
        state.counters["hierarchy_reported_MB"] = bare.reported * 1e-6;
        state.counters["hierarchy_resident_MB"] = bare.resident * 1e-6;
        state.counters["ratio_to_reported"] = peak / (vertices + bare.reported);
        state.counters["ratio_to_resident"] = peak / (vertices + bare.resident);
    }
}

BENCHMARK(memory_of_render)
    ->ArgName("triangles")
    ->Arg(1'000'000)
    ->Arg(10'000'000)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace emulsion::bench

BENCHMARK_MAIN();
