// What a large mesh takes to be rendered, beside what Embree alone needs for it.

#include <atomic>
#include <fstream>

#include <malloc.h>

#include "mesh_scene.h"
#include "pathtracer/embree.h"
#include "scene_bench.h"

namespace emulsion::bench {
namespace {

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

/// Counts what a device of Embree has allocated.
struct EmbreeMemory {
    std::atomic<std::int64_t> bytes{0}, peak_bytes{0};

    static bool count(void* counter, ssize_t bytes, bool /*after*/) {
        auto& memory = *static_cast<EmbreeMemory*>(counter);
        const std::int64_t now = memory.bytes += bytes;
        std::int64_t peak = memory.peak_bytes;
        while (peak < now && !memory.peak_bytes.compare_exchange_weak(peak, now)) {
        }
        return true;
    }
};

/// Builds Embree's compact hierarchy over a mesh, and nothing else. Threads as everywhere: all.
void build_bare(const TriangleMesh& mesh, RTCBuildQuality quality, EmbreeMemory& memory, double& after_commit) {
    RTCDevice device = rtcNewDevice(nullptr);
    rtcSetDeviceMemoryMonitorFunction(device, EmbreeMemory::count, &memory);
    RTCScene scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_COMPACT | RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, quality);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh.position.data(), 0,
                               sizeof(mesh.position[0]), mesh.position.size());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangle.data(), 0,
                               sizeof(mesh.triangle[0]), mesh.triangle.size());
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    after_commit = static_cast<double>(memory.bytes);
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
}

/// Argument: triangles.
void memory_of_render(benchmark::State& state) {
    const auto megabytes = [](double bytes) { return bytes * 1e-6; };
    for (auto _ : state) {
        forget_peak();
        const double before = resident_bytes("VmRSS");
        double prepared = 0.0, peak = 0.0, needed = 0.0, needed_peak = 0.0;
        {
            SceneBench scene(landscape_scene(state.range(0)));
            const double build_peak = resident_bytes("VmHWM") - before;
            prepared = resident_bytes("VmRSS") - before;
            forget_peak();
            scene.render_once({.samples_per_pixel = 1, .seed = 1});
            peak = resident_bytes("VmHWM") - before;
            state.counters["build_peak_MB"] = megabytes(build_peak);
            const auto& mesh = std::get<TriangleMesh>(scene.prepared().scene().shapes[0].geometry);
            const auto vertices = static_cast<double>(mesh.position.size() * sizeof(mesh.position[0]) +
                                                      mesh.triangle.size() * sizeof(mesh.triangle[0]));
            for (auto [q, name] :
                 {std::pair{RTC_BUILD_QUALITY_MEDIUM, "medium"}, std::pair{RTC_BUILD_QUALITY_HIGH, "high"}}) {
                EmbreeMemory memory;
                double after = 0.0;
                build_bare(mesh, q, memory, after);
                state.counters[std::string(name) + "_bvh"] = megabytes(after);
                state.counters[std::string(name) + "_bvh_peak"] = megabytes(static_cast<double>(memory.peak_bytes));
                if (needed == 0.0) {
                    needed = vertices + after;
                    needed_peak = vertices + static_cast<double>(memory.peak_bytes);
                }
            }
            state.counters["vertices_MB"] = megabytes(vertices);
        }
        state.counters["prepared_MB"] = megabytes(prepared);
        state.counters["render_peak_MB"] = megabytes(peak);
        state.counters["ratio"] = peak / needed;
        state.counters["needed_peak_MB"] = megabytes(needed_peak);
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
