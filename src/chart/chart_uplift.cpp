// RGB uplifts: the time of making a reflectance and reading it at four wavelengths, against how well its colour comes
// back, and how far it drifts from measured reflectances when the light changes.

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "chart/charts.h"
#include "chart/measure.h"
#include "core/random.h"
#include "spectrum/ciede2000_difference.h"
#include "spectrum/cielab.h"
#include "spectrum/colorimetry.h"
#include "spectrum/data_table.h"
#include "spectrum/rgb_uplift.h"
#include "spectrum/srgb_transfer.h"

namespace emulsion {

namespace {

constexpr std::array<double, 4> kLambda_nm = {423.4, 517.2, 588.8, 651.9};

double mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

/// CIEDE2000 over a grid that is even in encoded sRGB.
std::vector<double> round_trips(const RgbUplift& uplift, int levels) {
    const RgbSpace& space = rgb_space("sRGB");
    const Matrix3 matrix = xyz_from_rgb(space);
    const auto lab = [&](const RGBd& rgb) {
        const auto xyz = matrix * std::array<double, 3>{rgb.r, rgb.g, rgb.b};
        return lab_from_xyz({xyz[0], xyz[1], xyz[2]}, xyz_of(space.white));
    };
    const auto linear = [&](int i) { return decode(SrgbTransfer{}, static_cast<double>(i) / (levels - 1)); };
    std::vector<double> differences;
    for (int i = 0; i < levels * levels * levels; ++i) {
        const RGBd rgb = {linear(i % levels), linear(i / levels % levels), linear(i / levels / levels)};
        differences.push_back(difference(Ciede2000Difference{}, lab(rgb), lab(uplift.rgb_of(uplift.reflectance(rgb)))));
    }
    return differences;
}

std::vector<Spectrum> measured_reflectances(std::string_view table) {
    std::vector<Spectrum> reflectances;
    for (const std::string& name : data_table(table).column_names) {
        if (name == "wavelength") continue;
        PiecewiseLinearSpectrum reflectance = tabulated_spectrum(table, name);
        reflectance.extrapolation = Extrapolation::hold;
        reflectances.emplace_back(std::move(reflectance));
    }
    return reflectances;
}

/// CIEDE2000 between measured reflectances and uplifts of their colours, under another light.
std::vector<double> drifts(const RgbUplift& uplift, const std::vector<Spectrum>& reflectances, const char* illuminant) {
    const Spectrum light = tabulated_spectrum("illuminants_5nm", illuminant);
    const XYZd white = xyz_of_reflectance(ConstantSpectrum{1.0}, light);
    std::vector<double> differences;
    for (const Spectrum& original : reflectances) {
        const RGBd rgb = uplift.rgb_of(original);
        if (std::min({rgb.r, rgb.g, rgb.b}) < 0.0 || std::max({rgb.r, rgb.g, rgb.b}) > 1.0) continue;
        differences.push_back(difference(Ciede2000Difference{},
                                         lab_from_xyz(xyz_of_reflectance(original, light), white),
                                         lab_from_xyz(xyz_of_reflectance(uplift.reflectance(rgb), light), white)));
    }
    return differences;
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
    std::vector<Spectrum> reflectances = measured_reflectances("colorchecker_reflectance");
    for (Spectrum& more : measured_reflectances("reflectances_ampas24_5nm")) reflectances.push_back(std::move(more));

    std::vector<Work> works;
    for_each_alternative<UpliftMethod>([&]<class Method>(const Method& method) {
        const RgbUplift uplift(rgb_space("sRGB"), method);
        const std::string name(Method::kName);
        const std::array errors = {round_trips(uplift, levels), drifts(uplift, reflectances, "A"),
                                   drifts(uplift, reflectances, "FL11")};
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
