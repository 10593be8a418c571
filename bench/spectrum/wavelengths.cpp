// Strategies for the wavelengths of a path: how far one estimate of XYZ is off, by strategy, number of wavelengths and
// light, and what the wavelengths cost beside their double-precision twin. docs/wavelength-sampling.md has the results.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <type_traits>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/random.h"
#include "spectrum/colorimetry.h"
#include "spectrum/data_table.h"
#include "spectrum/wavelength_sampler.h"

namespace emulsion {
namespace {

// A light on a white reflector.
struct Light {
    std::string name;
    Spectrum continuum;
    std::vector<Line> lines;
};

std::vector<Light> lights() {
    const auto tabulated = [](const char* name) {
        return Light{name, tabulated_spectrum("illuminants_5nm", name), {}};
    };
    // Mercury's lines on a lamp's continuum: 29% of its X + Y + Z.
    return {tabulated("D65"), tabulated("FL11"), tabulated("HP1"),
            Light{"lines", BlackbodySpectrum{3000.0}, {{435.833, 6.0}, {546.074, 12.0}, {578.013, 9.0}}}};
}

WavelengthImportance importance_of(const Light& light) {
    return wavelength_importance(sum_of(light.continuum, LineSpectrum{light.lines, {}}));
}

XYZd exact_xyz(const Light& light) {
    XYZd xyz = (1.0 / kLuminousEfficacy) * xyz_of_radiance(light.continuum);
    for (const Line& line : light.lines) xyz = xyz + line.power * eval(cie_1931_2deg(), line.lambda_nm);
    return xyz;
}

template <int N>
XYZd estimate(const Light& light, const SampledLineWavelengths<N>& wavelengths) {
    XYZd sum;
    for (std::size_t i = 0; i < N; ++i) {
        const auto lambda_nm = static_cast<double>(wavelengths.lambda_nm[i]);
        const std::int32_t line = wavelengths.line[i];
        const double radiance =
            line == kNoLine ? eval(light.continuum, lambda_nm) : light.lines[static_cast<std::size_t>(line)].power;
        sum = sum + radiance / static_cast<double>(wavelengths.pdf[i]) * eval(cie_1931_2deg(), lambda_nm);
    }
    return (1.0 / N) * sum;
}

// Relative RMS error of X, Y and Z.
template <int N>
XYZd relative_rms(const WavelengthSampler& sampler, const Light& light) {
    constexpr int kEstimates = 40000;
    const XYZd exact = exact_xyz(light);
    Pcg32 random(N);
    XYZd square;
    for (int i = 0; i < kEstimates; ++i) {
        const XYZd xyz = estimate(light, sample_wavelengths<N>(sampler, [&] { return random.next_float(); }));
        const XYZd error = {xyz.x / exact.x - 1.0, xyz.y / exact.y - 1.0, xyz.z / exact.z - 1.0};
        square = square + XYZd{error.x * error.x, error.y * error.y, error.z * error.z};
    }
    return {std::sqrt(square.x / kEstimates), std::sqrt(square.y / kEstimates), std::sqrt(square.z / kEstimates)};
}

void print_errors() {
    std::printf("Relative RMS error of one estimate: Y (X, Z); \"misses\" where lines can't be seen\n| strategy | N |");
    const std::vector<Light> all = lights();
    for (const Light& light : all) std::printf(" %s |", light.name.c_str());
    std::printf("\n| --- | ---: | --- | --- | --- | --- |\n");
    for_each_alternative<WavelengthStrategy>([&]<class Strategy>(const Strategy& strategy) {
        for_each_wavelength_count([&]<int N>() {
            std::printf("| %s | %d |", std::string(Strategy::kName).c_str(), N);
            for (const Light& light : all) {
                if (!light.lines.empty() && !std::is_same_v<Strategy, HeroLines>) {
                    std::printf(" misses |");
                    continue;
                }
                const WavelengthSampler sampler = prepare(strategy, importance_of(light));
                const XYZd rms = relative_rms<N>(sampler, light);
                std::printf(" %.3f (%.3f, %.3f) |", rms.y, rms.x, rms.z);
            }
            std::printf("\n");
        });
    });
}

// Random numbers made beforehand: they are no part of what is timed.
class Numbers {
  public:
    Numbers() {
        Pcg32 random(1);
        for (float& number : numbers_) number = random.next_float();
    }
    float operator()() noexcept { return numbers_[next_++ % numbers_.size()]; }

  private:
    std::array<float, 4096> numbers_{};
    std::size_t next_ = 0;
};

// What is timed must also be right.
template <int N>
bool twins_agree(const WavelengthSampler& sampler) {
    Numbers a, b;
    for (int i = 0; i < 1000; ++i) {
        const auto fast = sample_wavelengths<N>(sampler, a);
        const auto exact = sample_wavelengths_reference<N>(sampler, b);
        for (std::size_t k = 0; k < N; ++k) {
            const bool near = std::abs(static_cast<double>(fast.lambda_nm[k]) - exact[k].lambda_nm) <= 1e-4 &&
                              std::abs(static_cast<double>(fast.pdf[k]) / exact[k].pdf - 1.0) <= 1e-6 &&
                              fast.line[k] == exact[k].line;
            if (!near) return false;
        }
    }
    return true;
}

std::vector<WavelengthStrategy> strategies() {
    std::vector<WavelengthStrategy> all;
    for_each_alternative<WavelengthStrategy>([&](const auto& strategy) { all.emplace_back(strategy); });
    return all;
}

// draw(sampler, numbers, N as a constant) for the strategy and N of the state.
template <class Draw>
void time_drawing(benchmark::State& state, const Draw& draw) {
    const WavelengthStrategy strategy = strategies()[static_cast<std::size_t>(state.range(0))];
    const WavelengthSampler sampler = prepare(strategy, importance_of(lights().back()));
    state.SetLabel(to_text(strategy));
    for_each_wavelength_count([&]<int N>() {
        if (state.range(1) != N) return;
        if (!twins_agree<N>(sampler)) {
            state.SkipWithError("the fast path differs from its twin");
            return;
        }
        Numbers numbers;
        for (auto _ : state) benchmark::DoNotOptimize(draw(sampler, numbers, std::integral_constant<int, N>{}));
        using benchmark::Counter;
        state.counters["per_wavelength"] =
            Counter(N, Counter::kIsIterationInvariantRate | Counter::kInvert, Counter::kIs1000);
    });
}

void fast(benchmark::State& state) {
    time_drawing(state, []<int N>(const WavelengthSampler& sampler, Numbers& numbers, std::integral_constant<int, N>) {
        return sample_wavelengths<N>(sampler, numbers);
    });
}

void twin(benchmark::State& state) {
    time_drawing(state, []<int N>(const WavelengthSampler& sampler, Numbers& numbers, std::integral_constant<int, N>) {
        return sample_wavelengths_reference<N>(sampler, numbers);
    });
}

void every_strategy_and_count(benchmark::internal::Benchmark* registered) {
    registered->ArgNames({"strategy", "N"})->MinTime(0.02)->Repetitions(5)->ReportAggregatesOnly(true);
    for (std::size_t strategy = 0; strategy < strategies().size(); ++strategy) {
        for (const int n : kWavelengthCounts) registered->Args({static_cast<std::int64_t>(strategy), n});
    }
}

BENCHMARK(fast)->Apply(every_strategy_and_count);
BENCHMARK(twin)->Apply(every_strategy_and_count);

}  // namespace
}  // namespace emulsion

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    emulsion::print_errors();
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
