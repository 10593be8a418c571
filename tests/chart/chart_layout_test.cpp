#include "chart/chart_layout.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "core/random.h"

namespace emulsion {
namespace {

Chart crowded(int points, AxisScale scale) {
    Chart chart{.name = "c", .title = "t", .note = std::string(300, 'n') + " " + std::string(20, 'm')};
    ChartPanel& panel = chart.panels.emplace_back();
    panel.title = "panel";
    panel.x.scale = panel.y.scale = scale;
    Pcg32 random(4);
    for (int i = 0; i < points; ++i) {
        panel.points.push_back({.series = "series " + std::to_string(i % 5),
                                .label = "label-" + std::to_string(i),
                                .x = exactly(std::pow(10.0, 2.0 * static_cast<double>(random.next_float()))),
                                .y = exactly(std::pow(10.0, 4.0 * static_cast<double>(random.next_float()) - 2.0))});
    }
    return chart;
}

TEST(ChartLayout, HasAllPointsInsideAndTicksInOrder) {
    for (const AxisScale scale : {AxisScale::log, AxisScale::linear}) {
        const Chart chart = crowded(12, scale);
        const ChartLayout layout = layout_of(chart);
        const PanelLayout& panel = layout.panels.at(0);
        EXPECT_LT(panel.frame.bottom, layout.height_px);
        EXPECT_LT(panel.frame.right, layout.width_px);
        for (const ChartPoint& point : chart.panels[0].points) {
            const double share = share_of(chart.panels[0].y, panel.y, point.y.median);
            EXPECT_GT(share, 0.0);
            EXPECT_LT(share, 1.0);
        }
        for (const AxisLayout* axis : {&panel.x, &panel.y}) {
            EXPECT_GE(axis->ticks.size(), 3u);
            EXPECT_LE(axis->ticks.size(), 12u);
            EXPECT_TRUE(std::is_sorted(axis->ticks.begin(), axis->ticks.end(),
                                       [](const AxisTick& a, const AxisTick& b) { return a.value < b.value; }));
            for (const AxisTick& tick : axis->ticks) EXPECT_TRUE(tick.value >= axis->from && tick.value <= axis->to);
        }
    }
}

TEST(ChartLayout, AxesOfAnyWidthHaveTicks) {
    for (const double width : {1.0, 1.001, 1.3, 2.0, 9.0, 1e3, 1e9, 1e20}) {
        Chart chart = crowded(1, AxisScale::log);
        chart.panels[0].points.push_back(chart.panels[0].points[0]);
        chart.panels[0].points[1].x = exactly(width * chart.panels[0].points[0].x.median);
        const std::size_t ticks = layout_of(chart).panels[0].x.ticks.size();
        EXPECT_GE(ticks, 1u) << width;
        EXPECT_LE(ticks, 12u) << width;
    }
}

/// Rough boxes of the texts, 5 pixels a character.
TEST(ChartLayout, KeepsLabelsApart) {
    const ChartLayout layout = layout_of(crowded(15, AxisScale::log));
    std::vector<PixelBox> boxes;
    for (const PlacedLabel& label : layout.panels[0].labels) {
        const double width = 5.0 * static_cast<double>(label.text.size());
        double left = label.x_px + 8.0, y = label.y_px + label.shift_px;
        if (label.side == LabelSide::left) left = label.x_px - 8.0 - width;
        if (label.side == LabelSide::above || label.side == LabelSide::below) left = label.x_px - 0.5 * width;
        if (label.side == LabelSide::above) y -= 14.0;
        if (label.side == LabelSide::below) y += 14.0;
        boxes.push_back({left, y - 5.0, left + width, y + 5.0});
    }
    ASSERT_EQ(boxes.size(), 15u);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const bool apart = boxes[i].left >= boxes[j].right || boxes[j].left >= boxes[i].right ||
                               boxes[i].top >= boxes[j].bottom || boxes[j].top >= boxes[i].bottom;
            EXPECT_TRUE(apart) << i << " and " << j;
        }
    }
}

TEST(ChartLayout, TellsOnceWhatLiesInOnePlace) {
    Chart chart = crowded(3, AxisScale::log);
    ChartPoint around = chart.panels[0].points[1];
    around.series = "choice";
    around.label = "choice: " + around.label;
    chart.panels[0].points.push_back(around);
    EXPECT_TRUE(is_around_another(chart.panels[0], 3));
    EXPECT_FALSE(is_around_another(chart.panels[0], 1));
    std::vector<std::string> texts;
    for (const PlacedLabel& label : layout_of(chart).panels[0].labels) texts.push_back(label.text);
    EXPECT_THAT(texts, testing::ElementsAre("label-0", "label-2", "choice: label-1"));
    // A label that does not tell the other's leaves it where it was.
    chart.panels[0].points[3].label = "choice";
    EXPECT_EQ(layout_of(chart).panels[0].labels.size(), 4u);
}

TEST(ChartLayout, NamesSeriesInALegendUnlessLabelsDo) {
    Chart chart = crowded(12, AxisScale::log);
    EXPECT_EQ(layout_of(chart).legend.size(), 5u);
    for (ChartPoint& point : chart.panels[0].points) point.label = point.series;
    EXPECT_TRUE(layout_of(chart).legend.empty());
}

TEST(ChartLayout, BreaksLongNotes) { EXPECT_EQ(layout_of(crowded(1, AxisScale::log)).note_lines.size(), 3u); }

}  // namespace
}  // namespace emulsion
