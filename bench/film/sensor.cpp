// What turning four wavelengths into XYZ costs, by kind of sensor. Items are conversions. The baseline of the ratios is
// the double-precision twin; all fast ones should cost the same, as a sensor of any kind is one table. Divide the times
// of one run. Each benchmark first verifies that its conversions agree with the twin to the stated 4e-6.

#include "film/sensor.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/random.h"
#include "spectrum/wavelength_sampling.h"

namespace emulsion {
namespace {

constexpr std::size_t kSamples = 4096;

struct Sample {
    SampledWavelengths<4> wavelengths;
    SampledSpectrum<4> radiance;
};

const std::vector<Sample>& samples() {
    static const std::vector<Sample> made = [] {
        std::vector<Sample> all(kSamples);
        Pcg32 random(1);
        const VisibleWavelengthPdf distribution;
        for (Sample& sample : all) {
            sample.wavelengths = hero_wavelengths<4>(distribution, random.next_float());
            for (int k = 0; k < 4; ++k) sample.radiance[k] = random.next_float();
        }
        return all;
    }();
    return made;
}

CameraResponse some_camera() {
    CameraResponse camera{"some", {}, {}};
    for (int nm = 380; nm <= 780; nm += 5) {
        const auto hump = [&](double centre_nm) { return std::exp(-std::pow((nm - centre_nm) / 50.0, 2.0)); };
        camera.lambda_nm.push_back(nm);
        camera.value.push_back({hump(600.0), hump(540.0), hump(455.0)});
    }
    return camera;
}

const SensorOptions kDefault{};
const SensorOptions kObserver1964{.observer = "1964"};
const SensorOptions kBalanced{.iso = 400.0, .white_balance = WhiteBalance{TemperatureWhite{3200.0}}};
const SensorOptions kCamera{.camera = CameraSensor{some_camera(), {}}};

bool agrees(const Sensor& sensor) {
    for (const auto& [wavelengths, radiance] : samples()) {
        const XYZ fast = sensor.to_xyz(wavelengths, radiance);
        const XYZd exact = sensor.to_xyz_reference(wavelengths, radiance);
        double size = 0.0;
        for (std::size_t i = 0; i < 4; ++i) {
            const XYZd response = sensor.response(static_cast<double>(wavelengths.lambda_nm[i]));
            size += static_cast<double>(radiance.value[i]) / static_cast<double>(wavelengths.pdf[i]) / 4.0 *
                    (std::abs(response.x) + std::abs(response.y) + std::abs(response.z));
        }
        const std::array<double, 3> off = {static_cast<double>(fast.x) - exact.x, static_cast<double>(fast.y) - exact.y,
                                           static_cast<double>(fast.z) - exact.z};
        for (const double value : off) {
            if (std::abs(value) > 4e-6 * size) return false;
        }
    }
    return true;
}

void reference4(benchmark::State& state) {
    const Sensor sensor;
    for (auto _ : state) {
        XYZd sum;
        for (const auto& [wavelengths, radiance] : samples()) {
            sum = sum + sensor.to_xyz_reference(wavelengths, radiance);
        }
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kSamples));
}

void fast4(benchmark::State& state, const SensorOptions& options) {
    const Sensor sensor(options);
    if (!agrees(sensor)) return state.SkipWithError("differs from the reference");
    for (auto _ : state) {
        XYZ sum;
        for (const auto& [wavelengths, radiance] : samples()) sum = sum + sensor.to_xyz(wavelengths, radiance);
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kSamples));
}

/// The same where the number of wavelengths is not known to the compiler.
void spans4(benchmark::State& state) {
    const Sensor sensor;
    for (const auto& [wavelengths, radiance] : samples()) {
        if (sensor.sense(wavelengths.lambda_nm, radiance.value, wavelengths.pdf).xyz !=
            sensor.to_xyz(wavelengths, radiance)) {
            return state.SkipWithError("differs from that of four wavelengths");
        }
    }
    for (auto _ : state) {
        XYZ sum;
        for (const auto& [wavelengths, radiance] : samples()) {
            sum = sum + sensor.sense(wavelengths.lambda_nm, radiance.value, wavelengths.pdf).xyz;
        }
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kSamples));
}

/// What making a sensor costs, once a film.
void make(benchmark::State& state, const SensorOptions& options) {
    for (auto _ : state) benchmark::DoNotOptimize(Sensor(options));
}

/// Prints mean, median and spread of nine runs.
void nine_times(benchmark::internal::Benchmark* benchmark) { benchmark->Repetitions(9)->ReportAggregatesOnly(); }

BENCHMARK(reference4)->Apply(nine_times);
BENCHMARK_CAPTURE(fast4, default_1931, kDefault)->Apply(nine_times);
BENCHMARK(spans4)->Apply(nine_times);
BENCHMARK_CAPTURE(fast4, observer_1964, kObserver1964)->Apply(nine_times);
BENCHMARK_CAPTURE(fast4, white_balanced, kBalanced)->Apply(nine_times);
BENCHMARK_CAPTURE(fast4, camera, kCamera)->Apply(nine_times);
BENCHMARK_CAPTURE(make, default_1931, kDefault)->Unit(benchmark::kMicrosecond)->Apply(nine_times);
BENCHMARK_CAPTURE(make, camera, kCamera)->Unit(benchmark::kMicrosecond)->Apply(nine_times);

}  // namespace
}  // namespace emulsion

BENCHMARK_MAIN();
