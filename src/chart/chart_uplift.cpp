// RGB uplifts: the time of making a reflectance and reading it at four wavelengths, against how well its colour comes
// back, and how far it drifts from measured reflectances when the light changes.

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "chart/charts.h"
#include "chart/measure.h"
#include "chart/uplift_errors.h"
#include "core/random.h"
#include "spectrum/rgb_uplift.h"

namespace emulsion {

namespace {

constexpr std::array<double, 4> kLambda_nm = {423.4, 517.2, 588.8, 651.9};

double mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

constexpr int kColoursOfWork = 16;

Work timed_colours(const RgbUplift& uplift) {
    return [uplift] {
        Pcg32 random(1);
        for (int i = 0; i < kColoursOfWork; ++i) {
            const Spectrum reflectance =
                uplift.reflectance({random.next_float(), random.next_float(), random.next_float()});
            std::array<double, 4> values{};
            eval(reflectance, kLambda_nm, values);
            keep(values);
        }
    };
}

}  // namespace

Chart measure_uplift_chart(const ChartOptions& options) {
    const bool quick = options.effort == ChartEffort::quick;
    const int levels = quick ? 5 : 17;
    Chart chart{.name = "uplift",
                .title = "Reflectances for sRGB colours: methods",
                .note =
                    "Time of making one reflectance and reading it at 4 wavelengths. Mean CIEDE2000: of the colour "
                    "that comes back under D65, over a grid of " +
                    std::to_string(levels) +
                    "^3 colours; and between 48 measured reflectances, as far as within sRGB, and the uplifts of "
                    "their colours, under A and FL11."};
    const ChartAxis time = {.label = "time / time of sigmoid"};
    chart.panels = {{.title = "Round trip", .x = time, .y = {.label = "CIEDE2000", .least_drawn = 1e-6}},
                    {.title = "Relit by A", .x = time, .y = {.label = "CIEDE2000", .least_drawn = 1e-3}},
                    {.title = "Relit by FL11", .x = time, .y = {.label = "CIEDE2000", .least_drawn = 1e-3}}};
    std::vector<Work> works;
    for_each_alternative<UpliftMethod>([&]<class Method>(const Method& method) {
        const RgbUplift uplift(rgb_space("sRGB"), method);
        const std::string name(Method::kName);
        const std::array errors = {round_trips(uplift, rgb_space("sRGB"), levels), drifts(uplift, "A"),
                                   drifts(uplift, "FL11")};
        for (std::size_t i = 0; i < errors.size(); ++i) {
            chart.panels[i].points.push_back(
                {.series = name,
                 .label = name,
                 .y = exactly(mean(errors[i])),
                 .details = {{"max", *std::max_element(errors[i].begin(), errors[i].end())}}});
        }
        works.push_back(timed_colours(uplift));
    });
    const std::vector<RelativeTime> times =
        times_relative_to(timed_colours(RgbUplift(rgb_space("sRGB"))), works, timing_options(options));
    for (ChartPanel& panel : chart.panels) set_times(panel, times, {.name = "ns", .factor = 1e9 / kColoursOfWork});
    return chart;
}

}  // namespace emulsion
