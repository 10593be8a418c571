// Evaluating spectra: one wavelength at a time and a span of them, per type, the renderer's table beside its twin in
// double precision, and exact integrals beside sums by 1 nm. Times are per wavelength (items) or per XYZ.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/random.h"
#include "spectrum/colorimetry.h"
#include "spectrum/data_table.h"
#include "spectrum/spectrum_table.h"

namespace emulsion {
namespace {

constexpr std::size_t kCount = 471;

Spectrum d65() { return tabulated_spectrum("illuminants_a_d_300_830_5nm", "D65"); }
Spectrum red() { return tabulated_spectrum("colorchecker_reflectance", "red"); }
Spectrum sigmoid() { return SigmoidSpectrum{{8.0, -6.0, 0.3}}; }

std::vector<std::pair<std::string, Spectrum>> bench_spectra() {
    DenseSpectrum dense{360.0, 1.0, std::vector<double>(kCount)};
    for (std::size_t i = 0; i < kCount; ++i) dense.value[i] = eval(d65(), dense.lambda_nm(i));
    const LineSpectrum lines{{}, {{435.8, 2.0, 1.0}, {546.1, 2.0, 2.0}, {611.0, 4.0, 3.0}}};
    return {{"constant", ConstantSpectrum{0.5}},
            {"piecewise_linear", d65()},
            {"dense", dense},
            {"blackbody", BlackbodySpectrum{2856.0}},
            {"daylight", DaylightSpectrum{5000.0}},
            {"sigmoid", sigmoid()},
            {"rgb_illuminant", RgbIlluminantSpectrum{std::get<SigmoidSpectrum>(sigmoid()),
                                                     std::get<PiecewiseLinearSpectrum>(d65()), 2.0}},
            {"three_gaussians", lines},
            {"product", product_of(d65(), red())},
            {"sum", sum_of(d65(), lines, 1.0, 2.0)}};
}

/// Increasing, as integrals and tables ask for them, a nanometre apart but for rounding.
std::vector<double> wavelengths() {
    Pcg32 random(1);
    std::vector<double> lambda_nm(kCount);
    for (std::size_t i = 0; i < kCount; ++i) {
        lambda_nm[i] = 360.0 + static_cast<double>(i) * 0.998 + static_cast<double>(random.next_float());
    }
    return lambda_nm;
}

/// The benchmark's spectrum, whose name becomes its label.
Spectrum spectrum_of(benchmark::State& state) {
    static const auto all = bench_spectra();
    const auto& [name, spectrum] = all.at(static_cast<std::size_t>(state.range(0)));
    state.SetLabel(name);
    return spectrum;
}

void one_by_one(benchmark::State& state) {
    const Spectrum spectrum = spectrum_of(state);
    const std::vector<double> lambda_nm = wavelengths();
    std::vector<double> values(kCount);
    for (auto _ : state) {
        for (std::size_t i = 0; i < kCount; ++i) values[i] = eval(spectrum, lambda_nm[i]);
        benchmark::DoNotOptimize(values.data());
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(kCount) * state.iterations());
}

void span(benchmark::State& state) {
    const Spectrum spectrum = spectrum_of(state);
    const std::vector<double> lambda_nm = wavelengths();
    std::vector<double> values(kCount);
    eval(spectrum, lambda_nm, values);
    for (std::size_t i = 0; i < kCount; ++i) {
        if (values[i] == eval(spectrum, lambda_nm[i])) continue;
        state.SkipWithError("a span's value differs from eval's");
        return;
    }
    for (auto _ : state) {
        eval(spectrum, lambda_nm, values);
        benchmark::DoNotOptimize(values.data());
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(kCount) * state.iterations());
}

// The renderer's form, four wavelengths at a time, their places in the table worked out anew.
void float_table(benchmark::State& state) {
    const Spectrum spectrum = spectrum_of(state);
    const SpectrumTable table(spectrum);
    const std::vector<double> lambda_nm = wavelengths();
    std::vector<std::array<float, 4>> fours(kCount / 4);
    double largest = 0.0, difference = 0.0;
    for (std::size_t i = 0; i < 4 * fours.size(); ++i) {
        fours[i / 4][i % 4] = static_cast<float>(lambda_nm[i]);
        const double exact = eval(spectrum, static_cast<double>(fours[i / 4][i % 4]));
        const SpectrumTableIndex<1> index({fours[i / 4][i % 4]});
        largest = std::max(largest, std::abs(exact));
        difference = std::max(difference, std::abs(exact - static_cast<double>(table.at(index)[0])));
    }
    // The Gaussians of 2 nm; the rest are much closer, and the tests say how close.
    if (difference > 0.05 * largest) {
        state.SkipWithError("the table differs from eval by more than 5%");
        return;
    }
    for (auto _ : state) {
        for (const auto& four : fours) benchmark::DoNotOptimize(table.at(SpectrumTableIndex<4>(four)));
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(4 * fours.size()) * state.iterations());
}

bool agrees(const XYZd& a, const XYZd& b) {
    return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z) < 1e-3;
}

void exact_integral(benchmark::State& state, const Spectrum& reflectance, const Spectrum& illuminant) {
    if (!agrees(xyz_of_reflectance(reflectance, illuminant), xyz_by_summation(reflectance, illuminant))) {
        state.SkipWithError("integral and sum are more than 1e-3 apart");
        return;
    }
    for (auto _ : state) benchmark::DoNotOptimize(xyz_of_reflectance(reflectance, illuminant));
}

void sum_by_1nm(benchmark::State& state, const Spectrum& reflectance, const Spectrum& illuminant) {
    for (auto _ : state) benchmark::DoNotOptimize(xyz_by_summation(reflectance, illuminant));
}

void make_table(benchmark::State& state) {
    const Spectrum spectrum = spectrum_of(state);
    for (auto _ : state) benchmark::DoNotOptimize(SpectrumTable(spectrum));
}

void every_spectrum(benchmark::internal::Benchmark* benchmark) {
    benchmark->ArgName("spectrum")
        ->DenseRange(0, static_cast<std::int64_t>(bench_spectra().size()) - 1)
        ->Repetitions(5)
        ->ReportAggregatesOnly(true);
}

BENCHMARK(one_by_one)->Apply(every_spectrum);
BENCHMARK(span)->Apply(every_spectrum);
BENCHMARK(float_table)->Apply(every_spectrum);
BENCHMARK(make_table)->Apply(every_spectrum);
BENCHMARK_CAPTURE(exact_integral, tables, red(), d65())->Repetitions(5);
BENCHMARK_CAPTURE(sum_by_1nm, tables, red(), d65())->Repetitions(5);
BENCHMARK_CAPTURE(exact_integral, smooth, sigmoid(), BlackbodySpectrum{2856.0})->Repetitions(5);
BENCHMARK_CAPTURE(sum_by_1nm, smooth, sigmoid(), BlackbodySpectrum{2856.0})->Repetitions(5);

}  // namespace
}  // namespace emulsion

BENCHMARK_MAIN();
