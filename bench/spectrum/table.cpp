// The renderer's table of a spectrum beside its specification, eval in double precision: four wavelengths at a time.

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/random.h"
#include "spectrum/data_table.h"
#include "spectrum/spectrum_table.h"
#include "spectrum/wavelength_sampling.h"

namespace emulsion {
namespace {

constexpr int kWavelengths = 4;
constexpr std::size_t kPaths = 1024;

Spectrum bench_spectrum() { return tabulated_spectrum("illuminants_a_d_300_830_5nm", "D65"); }

std::vector<std::array<float, kWavelengths>> sampled_wavelengths() {
    const VisibleWavelengthPdf distribution;
    Pcg32 random(1);
    std::vector<std::array<float, kWavelengths>> wavelengths(kPaths);
    for (auto& lambda_nm : wavelengths) {
        lambda_nm = hero_wavelengths<kWavelengths>(distribution, random.next_float()).lambda_nm;
    }
    return wavelengths;
}

SampledSpectrum<kWavelengths> eval_all(const Spectrum& spectrum, const std::array<float, kWavelengths>& lambda_nm) {
    SampledSpectrum<kWavelengths> values;
    for (std::size_t i = 0; i < kWavelengths; ++i) {
        values.value[i] = static_cast<float>(eval(spectrum, static_cast<double>(lambda_nm[i])));
    }
    return values;
}

bool agrees(const SpectrumTable& table, const Spectrum& spectrum) {
    for (const auto& lambda_nm : sampled_wavelengths()) {
        const auto fast = table.at(SpectrumTableIndex<kWavelengths>(lambda_nm)), exact = eval_all(spectrum, lambda_nm);
        for (int i = 0; i < kWavelengths; ++i) {
            if (std::abs(fast[i] - exact[i]) > 1e-6f * exact.max()) return false;
        }
    }
    return true;
}

void eval_twin(benchmark::State& state) {
    const Spectrum spectrum = bench_spectrum();
    const auto wavelengths = sampled_wavelengths();
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(eval_all(spectrum, wavelengths[i]));
        i = (i + 1) % kPaths;
    }
}

// A path works its index out once and meets several spectra: both are timed, with and without it.
void table_with_index(benchmark::State& state) {
    const SpectrumTable table(bench_spectrum());
    if (!agrees(table, bench_spectrum())) {
        state.SkipWithError("the table differs from eval by more than 1e-6");
        return;
    }
    const auto wavelengths = sampled_wavelengths();
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(table.at(SpectrumTableIndex<kWavelengths>(wavelengths[i])));
        i = (i + 1) % kPaths;
    }
}

void table_alone(benchmark::State& state) {
    const SpectrumTable table(bench_spectrum());
    std::vector<SpectrumTableIndex<kWavelengths>> indices;
    for (const auto& lambda_nm : sampled_wavelengths()) indices.emplace_back(lambda_nm);
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(table.at(indices[i]));
        i = (i + 1) % kPaths;
    }
}

BENCHMARK(eval_twin)->Repetitions(5);
BENCHMARK(table_with_index)->Repetitions(5);
BENCHMARK(table_alone)->Repetitions(5);

}  // namespace
}  // namespace emulsion

BENCHMARK_MAIN();
