// Tone mapping: every operator as it maps pictures, and its double-precision twin.

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "chart/charts.h"
#include "chart/measure.h"
#include "chart/test_scene.h"
#include "spectrum/ciede2000_difference.h"
#include "spectrum/cielab.h"
#include "tonemap/tone_mapper.h"

namespace emulsion {

namespace {

constexpr XYZ kWhite{0.95047f, 1.0f, 1.08883f};
constexpr XYZd kWhiteD{0.95047, 1.0, 1.08883};

/// As a display shows it: what is above white is scaled down to it.
Lab shown(const XYZd& pixel) { return lab_from_xyz((1.0 / std::max(pixel.y, 1.0)) * pixel, kWhiteD); }

std::vector<double> differences(const Image<XYZ>& fast, const Image<XYZd>& exact) {
    std::vector<double> all;
    for (std::size_t i = 0; i < fast.pixels().size(); ++i) {
        const XYZ& p = fast.pixels()[i];
        all.push_back(difference(Ciede2000Difference{}, shown(exact.pixels()[i]), shown(XYZd{p.x, p.y, p.z})));
    }
    return all;
}

}  // namespace

Chart measure_tonemap_chart(const ChartOptions& options) {
    const bool quick = options.effort == ChartEffort::quick;
    const int width = quick ? 96 : 384, height = quick ? 64 : 256;
    const Image<XYZ> scene = chart_scene(width, height);
    const double pixels = static_cast<double>(width) * height;
    Chart chart{.name = "tonemap",
                .title = "Tone mapping operators, and what their speed loses",
                .note = fmt::format("{}x{} pixels, one thread. Error: mean CIEDE2000 on the display against the "
                                    "operator's twin in double precision, which follows its source "
                                    "to the letter. How far operators differ from each other is a matter of taste, and "
                                    "not here.",
                                    width, height)};
    ChartPanel& panel = chart.panels.emplace_back();
    panel.x.label = "time / time of a memory copy of the picture";
    panel.y = {.label = "CIEDE2000 from the twin", .least_drawn = 1e-6};
    std::vector<Work> works;
    std::vector<double> twin_s;
    for_each_alternative<ToneMapper>([&]<class Mapper>(const Mapper& mapper) {
        const ToneMapping mapping{mapper};
        Image<XYZd> exact;
        twin_s.push_back(thread_seconds([&] { exact = tone_map_reference(mapping, scene.view(), kWhiteD); }));
        const std::vector<double> errors = differences(tone_map(mapping, scene.view(), kWhite, 1).image, exact);
        double sum = 0.0;
        for (const double error : errors) sum += error;
        panel.points.push_back({.series = std::string(is_local(own_adaptation(mapper)) ? "local" : "global"),
                                .label = std::string(Mapper::kName),
                                .y = exactly(sum / pixels),
                                .details = {{"max", *std::max_element(errors.begin(), errors.end())}}});
        works.push_back([mapping, scene, display = Image<XYZ>(width, height)]() mutable {
            tone_map_into(mapping, scene.view(), display.view(), kWhite, 1);
            keep(display.pixels()[0]);
        });
    });
    const Work copy = [scene, display = Image<XYZ>(width, height)]() mutable {
        std::copy(scene.pixels().begin(), scene.pixels().end(), display.pixels().begin());
        keep(display.pixels()[0]);
    };
    const std::vector<RelativeTime> times = times_relative_to(copy, works, timing_options(options));
    set_times(panel, times, {"Mpix/s", 1e-6 * pixels, TimeDetail::Kind::rate});
    for (std::size_t i = 0; i < times.size(); ++i) {
        panel.points[i].details.emplace_back("twin's time / its", twin_s[i] / times[i].seconds);
    }
    return chart;
}

}  // namespace emulsion
