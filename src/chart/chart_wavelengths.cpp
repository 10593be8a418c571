// Wavelengths of a path: the time of drawing them and estimating XYZ from them, against the error of one estimate.

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "chart/charts.h"
#include "chart/measure.h"
#include "chart/wavelength_estimates.h"
#include "spectrum/data_table.h"

namespace emulsion {

namespace {

/// D65, two discharge lamps, and a white light-emitting diode (CIE 15:2018's LED-B3).
std::vector<EstimatedLight> lights() {
    return {{.name = "D65", .continuum = tabulated_spectrum("illuminants_5nm", "D65")},
            {.name = "FL11", .continuum = tabulated_spectrum("illuminants_5nm", "FL11")},
            {.name = "HP1", .continuum = tabulated_spectrum("illuminants_5nm", "HP1")},
            {.name = "LED-B3", .continuum = tabulated_spectrum("illuminants_5nm", "LED_B3")}};
}

/// Of X, Y and Z together: sqrt(mean of the three squared relative errors), in batches that tell its spread.
template <int N>
Spread relative_rms(const WavelengthSampler& sampler, const EstimatedLight& light, int batches, int in_batch) {
    const XYZd exact = exact_xyz(light);
    Pcg32 random(N);
    std::vector<double> errors;
    for (int batch = 0; batch < batches; ++batch) {
        const XYZd square = mean_squared_error<N>(sampler, light, exact, in_batch, random);
        errors.push_back(std::sqrt((square.x + square.y + square.z) / 3.0));
    }
    return spread_of(errors);
}

constexpr int kEstimatesOfWork = 64;

template <int N>
Work timed_estimates(const WavelengthSampler& sampler, const EstimatedLight& light) {
    return [sampler, light] {
        Pcg32 random(1);
        for (int i = 0; i < kEstimatesOfWork; ++i) {
            keep(estimate<N>(light, sample_wavelengths<N>(sampler, [&] { return random.next_float(); })));
        }
    };
}

ChartPanel measured(const EstimatedLight& light, const ChartOptions& options) {
    const bool quick = options.effort == ChartEffort::quick;
    const int batches = quick ? 4 : 16, in_batch = quick ? 500 : 4000;
    const WavelengthImportance importance = importance_of(light);
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
                                    .y = relative_rms<N>(sampler, light, batches, in_batch),
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
    for (const EstimatedLight& light : lights()) chart.panels.push_back(measured(light, options));
    return chart;
}

}  // namespace emulsion
