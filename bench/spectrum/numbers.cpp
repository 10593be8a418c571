// From colours to single numbers: the time of one call, each checked against what it must give.

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/random.h"
#include "spectrum/color_rendering.h"
#include "spectrum/color_temperature.h"
#include "spectrum/data_table.h"
#include "spectrum/dominant_wavelength.h"
#include "spectrum/gamut.h"

namespace emulsion {
namespace {

constexpr Chromaticity kD65 = {0.3127, 0.3290};

// Monochromatic lights, half-way to white.
struct Hues {
    std::vector<double> lambda_nm;
    std::vector<Chromaticity> xy;
};

Hues random_hues() {
    Pcg32 random(1);
    Hues hues;
    for (int i = 0; i < 256; ++i) {
        const double lambda_nm = 400.0 + 290.0 * random.next_float();
        const Chromaticity locus = chromaticity_of(eval(cie_1931_2deg(), lambda_nm));
        hues.lambda_nm.push_back(lambda_nm);
        hues.xy.push_back({0.5 * (locus.x + kD65.x), 0.5 * (locus.y + kD65.y)});
    }
    return hues;
}

// Whites around the Planckian locus.
std::vector<CorrelatedColorTemperature> random_whites() {
    Pcg32 random(2);
    std::vector<CorrelatedColorTemperature> whites(256);
    for (CorrelatedColorTemperature& white : whites) {
        white = {1000.0 * std::pow(100.0, random.next_float()), 0.04 * (random.next_float() - 0.5)};
    }
    return whites;
}

void find_dominant_wavelength(benchmark::State& state) {
    const Hues hues = random_hues();
    for (std::size_t i = 0; i < hues.xy.size(); ++i) {
        if (std::abs(dominant_wavelength(hues.xy[i], kD65).lambda_nm - hues.lambda_nm[i]) < 1e-9) continue;
        state.SkipWithError("a wavelength was not found");
        return;
    }
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(dominant_wavelength(hues.xy[i], kD65));
        i = (i + 1) % hues.xy.size();
    }
}

void find_color_temperature(benchmark::State& state) {
    const PlanckianLocus& locus = cie_1931_planckian_locus();
    std::vector<Uv1960> uv;
    for (const CorrelatedColorTemperature& white : random_whites()) {
        uv.push_back(locus.uv(white));
        const auto found = locus.nearest(uv.back());
        if (found && std::abs(found->temperature_K / white.temperature_K - 1.0) < 1e-9) continue;
        state.SkipWithError("a colour temperature was not found");
        return;
    }
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(locus.nearest(uv[i]));
        i = (i + 1) % uv.size();
    }
}

void make_planckian_locus(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(PlanckianLocus(cie_1931_2deg()));
}

void make_spectral_locus(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(SpectralLocus(cie_1931_2deg()));
}

void inside_spectral_locus(benchmark::State& state) {
    const SpectralLocus& locus = cie_1931_spectral_locus();
    if (!(locus.signed_distance(kD65) > 0.0)) state.SkipWithError("white was found outside");
    for (auto _ : state) benchmark::DoNotOptimize(locus.signed_distance(kD65));
}

void inside_rgb_gamut(benchmark::State& state) {
    const RgbGamut gamut(rgb_space("sRGB"));
    XYZd grey = xyz_of(kD65, 0.25);
    if (!(std::abs(gamut.margin(grey) - 0.25) < 1e-12)) state.SkipWithError("a grey has the wrong margin");
    for (auto _ : state) {
        benchmark::DoNotOptimize(grey);
        benchmark::DoNotOptimize(gamut.margin(grey));
    }
}

void rendering_index(benchmark::State& state, ColorRenderingMethod::Integration integration) {
    const Spectrum lamp = tabulated_spectrum("illuminants_5nm", "FL2");
    const ColorRenderingMethod method{.integration = integration};
    if (std::abs(color_rendering(lamp, method).general_index - 64.0) > 0.5) state.SkipWithError("FL2's Ra is not 64");
    for (auto _ : state) benchmark::DoNotOptimize(color_rendering(lamp, method));
}

BENCHMARK(find_dominant_wavelength)->Unit(benchmark::kMicrosecond)->Repetitions(5);
BENCHMARK(find_color_temperature)->Unit(benchmark::kMicrosecond)->Repetitions(5);
BENCHMARK(make_planckian_locus)->Unit(benchmark::kMillisecond)->Repetitions(5);
BENCHMARK(make_spectral_locus)->Unit(benchmark::kMicrosecond)->Repetitions(5);
BENCHMARK(inside_spectral_locus)->Unit(benchmark::kNanosecond)->Repetitions(5);
BENCHMARK(inside_rgb_gamut)->Unit(benchmark::kNanosecond)->Repetitions(5);
BENCHMARK_CAPTURE(rendering_index, exact, ColorRenderingMethod::Integration::exact)
    ->Unit(benchmark::kMillisecond)
    ->Repetitions(5);
BENCHMARK_CAPTURE(rendering_index, every_5nm, ColorRenderingMethod::Integration::every_5nm)
    ->Unit(benchmark::kMillisecond)
    ->Repetitions(5);

}  // namespace
}  // namespace emulsion

BENCHMARK_MAIN();
