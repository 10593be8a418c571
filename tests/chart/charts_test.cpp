// Every chart, quickly: that it has its points, and that errors do what theory says. Times are not tested.

#include "chart/charts.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "core/named_value.h"
#include "spectrum/wavelength_strategy.h"

namespace emulsion {
namespace {

ChartOptions quick() { return {.effort = ChartEffort::quick, .threads = 2}; }

const ChartPanel& panel_of(const Chart& chart, const std::string& title) {
    const auto found = std::find_if(chart.panels.begin(), chart.panels.end(),
                                    [&](const ChartPanel& panel) { return panel.title == title; });
    if (found == chart.panels.end()) throw std::out_of_range("no panel " + title);
    return *found;
}

std::vector<ChartPoint> points_of(const ChartPanel& panel, const std::string& series) {
    std::vector<ChartPoint> points;
    for (const ChartPoint& point : panel.points) {
        if (point.series == series) points.push_back(point);
    }
    return points;
}

std::set<std::string> series_of(const ChartPanel& panel) {
    std::set<std::string> series;
    for (const ChartPoint& point : panel.points) series.insert(point.series);
    return series;
}

template <class Variant>
std::set<std::string> all_names() {
    const auto names = names_of<Variant>();
    return {names.begin(), names.end()};
}

TEST(WavelengthsChart, ErrorsFallWithTheNumberOfWavelengths) {
    const Chart chart = measure_chart("wavelengths", quick());
    ASSERT_EQ(chart.panels.size(), 4u);
    for (const ChartPanel& panel : chart.panels) {
        EXPECT_EQ(series_of(panel), all_names<WavelengthStrategy>());
        for (const std::string& series : series_of(panel)) {
            const std::vector<ChartPoint> points = points_of(panel, series);
            ASSERT_EQ(points.size(), 3u);
            for (std::size_t i = 1; i < points.size(); ++i) {
                EXPECT_LT(points[i].y.median, points[i - 1].y.median) << panel.title << " " << series;
            }
        }
        // Independent wavelengths: error^2 = variance / N. Each error is of 2000 squared deviates, so that of two of
        // them the logarithms differ by no more than 4 sqrt(kurtosis / 2000 / 2) = 0.15 from what they should with a
        // kurtosis of 6, which these bounded estimates don't reach.
        const std::vector<ChartPoint> independent = points_of(panel, "independent");
        EXPECT_NEAR(std::log2(independent[0].y.median / independent[2].y.median), 0.5 * 4.0, 0.3) << panel.title;
    }
}

TEST(Charts, RefuseWhatTheyDoNotKnow) {
    EXPECT_THAT([] { (void)measure_chart("wavelenghts", quick()); },
                testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("wavelengths")));
}

}  // namespace
}  // namespace emulsion
