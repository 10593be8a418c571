// The chart of transport models, quickly.

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "analysis/model_analysis.h"
#include "charts_fixture.h"

namespace emulsion {
namespace {

TEST(ModelsChart, HasAllModelsAtEqualSamplesAndInEqualTime) {
    ChartOptions options = quick();
    options.scenes = {EMULSION_SOURCE_DIR "/scenes/cornell-box.pbrt"};
    const Chart chart = measure_chart("models", options);
    ASSERT_EQ(chart.panels.size(), 2u);
    for (const ChartPanel& panel : chart.panels) {
        std::set<std::string> labels;
        for (const ChartPoint& point : panel.points) {
            labels.insert(point.label);
            EXPECT_GT(point.y.median, 0.0);
            EXPECT_LT(point.y.median, 20.0);
        }
        // And what auto takes, which for this box is one of them.
        EXPECT_EQ(labels, (std::set<std::string>{"rgb:sRGB", "rgb-prefiltered", "basis:6", "spectral:4",
                                                 "auto: rgb-prefiltered"}));
    }
    for (const ChartPoint& point : chart.panels[0].points) EXPECT_EQ(detail(point, "samples"), 32.0);
    for (const ChartPoint& point : chart.panels[1].points) EXPECT_EQ(detail(point, "samples"), point.x.median);
}

/// What a picture's difference from the reference comes to without the noise of both, and that less or more some
/// standard errors of its square.
double bias(const ChartPoint& point, double standard_errors) {
    const double share = detail(point, "share of bias") + standard_errors * detail(point, "its standard error");
    return point.y.median * std::sqrt(std::max(0.0, share));
}

TEST(ModelsChart, HasWhatAutoTakesAndItsErrorWithinTheBudget) {
    ChartOptions options = quick();
    for (const char* scene : {"metals", "folded-screen", "metamers", "prism"}) {
        options.scenes.emplace_back(fmt::format("{}/scenes/{}.pbrt", EMULSION_SOURCE_DIR, scene));
    }
    const Chart chart = measure_chart("models", options);
    ASSERT_EQ(chart.panels.size(), 2 * options.scenes.size());
    std::set<std::string> taken;
    for (const ChartPanel& panel : chart.panels) {
        const std::vector<ChartPoint> found = points_of(panel, "auto");
        ASSERT_EQ(found.size(), 1u) << panel.title;
        const ChartPoint& point = found[0];
        // It is the point of its model, which is measured even where the quick chart has not got it otherwise.
        const auto own = std::find_if(panel.points.begin(), panel.points.end(),
                                      [&](const ChartPoint& other) { return "auto: " + other.label == point.label; });
        ASSERT_NE(own, panel.points.end()) << point.label;
        EXPECT_EQ(own->x, point.x);
        EXPECT_EQ(own->y, point.y);
        EXPECT_EQ(own->on_front, point.on_front);
        EXPECT_GT(detail(point, "seconds of analysis"), 0.0);
        EXPECT_GT(detail(point, "analysis / rendering the file by rgb"), 0.0);
        // In equal time there are as many samples as there happened to be time for.
        if (panel.title.ends_with("a pixel")) {
            EXPECT_LE(bias(point, -3.0), ErrorBudget{}.mean) << panel.title;
        }
        taken.insert(point.label);
    }
    EXPECT_EQ(taken, (std::set<std::string>{"auto: rgb:sRGB", "auto: rgb-prefiltered", "auto: basis:4",
                                            "auto: spectral:4:hero-illuminant"}));
    // The budget is no empty word: rgb, which auto does not take for the screen, is out of it there.
    EXPECT_GT(bias(points_of(panel_of(chart, "folded-screen: 32 samples a pixel"), "rgb").at(0), -3.0),
              ErrorBudget{}.mean);
}

}  // namespace
}  // namespace emulsion
