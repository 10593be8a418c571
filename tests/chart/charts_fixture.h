#pragma once
// Charts measured quickly, and their points by name.

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "chart/charts.h"
#include "core/named_value.h"

namespace emulsion {

inline ChartOptions quick() { return {.effort = ChartEffort::quick, .threads = 2}; }

inline const ChartPanel& panel_of(const Chart& chart, const std::string& title) {
    const auto found = std::find_if(chart.panels.begin(), chart.panels.end(),
                                    [&](const ChartPanel& panel) { return panel.title == title; });
    if (found == chart.panels.end()) throw std::out_of_range("no panel " + title);
    return *found;
}

inline std::vector<ChartPoint> points_of(const ChartPanel& panel, const std::string& series) {
    std::vector<ChartPoint> points;
    for (const ChartPoint& point : panel.points) {
        if (point.series == series) points.push_back(point);
    }
    return points;
}

inline std::set<std::string> series_of(const ChartPanel& panel) {
    std::set<std::string> series;
    for (const ChartPoint& point : panel.points) series.insert(point.series);
    return series;
}

template <class Variant>
std::set<std::string> all_names() {
    const auto names = names_of<Variant>();
    return {names.begin(), names.end()};
}

}  // namespace emulsion
