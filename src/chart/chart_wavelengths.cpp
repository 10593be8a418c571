// Wavelengths of a path: the time of drawing them and estimating XYZ from them, against the error of one estimate.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "chart/charts.h"
#include "chart/measure.h"
#include "core/random.h"
#include "spectrum/colorimetry.h"
#include "spectrum/data_table.h"
#include "spectrum/wavelength_sampler.h"

namespace emulsion {

namespace {

// A light on a white reflector.
struct Light {
    std::string name;
    Spectrum spectrum;
};

/// D65, two discharge lamps, and a white light-emitting diode (CIE 15:2018's LED-B3).
std::vector<Light> lights() {
    return {{"D65", tabulated_spectrum("illuminants_5nm", "D65")},
            {"FL11", tabulated_spectrum("illuminants_5nm", "FL11")},
            {"HP1", tabulated_spectrum("illuminants_5nm", "HP1")},
            {"LED-B3", tabulated_spectrum("illuminants_5nm", "LED_B3")}};
}

template <int N>
XYZd estimate(const Light& light, const SampledLineWavelengths<N>& wavelengths) {
    XYZd sum;
    for (std::size_t i = 0; i < N; ++i) {
        const auto lambda_nm = static_cast<double>(wavelengths.lambda_nm[i]);
        sum = sum + eval(light.spectrum, lambda_nm) / static_cast<double>(wavelengths.pdf[i]) *
                        eval(cie_1931_2deg(), lambda_nm);
    }
    return (1.0 / N) * sum;
}

/// Of X, Y and Z together: sqrt(mean of the three squared relative errors), in batches that tell its spread.
template <int N>
Spread relative_rms(const WavelengthSampler& sampler, const Light& light, const XYZd& exact, int batches,
                    int in_batch) {
    Pcg32 random(N);
    std::vector<double> errors;
    for (int batch = 0; batch < batches; ++batch) {
        double square = 0.0;
        for (int i = 0; i < in_batch; ++i) {
            const XYZd xyz = estimate(light, sample_wavelengths<N>(sampler, [&] { return random.next_float(); }));
            for (const double error : {xyz.x / exact.x - 1.0, xyz.y / exact.y - 1.0, xyz.z / exact.z - 1.0}) {
                square += error * error / 3.0;
            }
        }
        errors.push_back(std::sqrt(square / in_batch));
    }
    return spread_of(errors);
}

constexpr int kEstimatesOfWork = 64;

template <int N>
Work timed_estimates(const WavelengthSampler& sampler, const Light& light) {
    return [sampler, light] {
        Pcg32 random(1);
        for (int i = 0; i < kEstimatesOfWork; ++i) {
            keep(estimate(light, sample_wavelengths<N>(sampler, [&] { return random.next_float(); })));
        }
    };
}

ChartPanel measured(const Light& light, const ChartOptions& options) {
    const bool quick = options.effort == ChartEffort::quick;
    const int batches = quick ? 4 : 16, in_batch = quick ? 500 : 4000;
    const XYZd exact = (1.0 / kLuminousEfficacy) * xyz_of_radiance(light.spectrum);
    const WavelengthImportance importance = wavelength_importance(sum_of(light.spectrum, LineSpectrum{{}, {}}));
    ChartPanel panel{.title = light.name,
                     .x = {.label = "time of an estimate / of one with hero-visible and N = 1"},
                     .y = {.label = "relative RMS error of XYZ"},
                     .lines = SeriesLines::joined};
    std::vector<Work> works;
    for_each_alternative<WavelengthStrategy>([&]<class Strategy>(const Strategy& strategy) {
        const WavelengthSampler sampler = prepare(strategy, importance);
        for_each_wavelength_count([&]<int N>() {
            if (quick && N != 1 && N != 4 && N != 16) return;
            panel.points.push_back({.series = std::string(Strategy::kName),
                                    .label = "",
                                    .y = relative_rms<N>(sampler, light, exact, batches, in_batch),
                                    .details = {{"N", N}}});
            works.push_back(timed_estimates<N>(sampler, light));
        });
    });

    const Work baseline = timed_estimates<1>(prepare(HeroVisible{}, importance), light);
    set_times(panel, times_relative_to(baseline, works, timing_options(options)),
              {.name = "ns", .factor = 1e9 / kEstimatesOfWork});
    return panel;
}

}  // namespace

Chart measure_wavelengths_chart(const ChartOptions& options) {
    Chart chart{.name = "wavelengths",
                .title = "Wavelengths of a path: strategies and numbers",
                .note =
                    "Estimates of XYZ of a light on a white reflector, one path each; along a line N is 1, 2, 4, 8, "
                    "16, 32 from the left. Error against the integral in double precision. The time is of drawing "
                    "and weighing alone: tracing the path costs more, and is shared by its N wavelengths."};
    for (const Light& light : lights()) chart.panels.push_back(measured(light, options));
    return chart;
}

}  // namespace emulsion
