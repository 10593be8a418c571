#include "chart/chart_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <fmt/format.h>

namespace emulsion {

namespace {

constexpr double kPanelHeight_px = 330.0, kTallPanelHeight_px = 500.0, kTitleHeight_px = 34.0;
constexpr double kNoteLine_px = 17.0, kLegendLine_px = 20.0;
constexpr double kLeft_px = 76.0, kRight_px = 18.0, kAbove_px = 34.0, kBelow_px = 52.0;  // around a panel's frame
// Of the fonts that gnuplot is told to use; wide letters are rare.
constexpr double kCharacter_px = 6.4, kLabelHeight_px = 13.0;
constexpr double kSign_px = 5.0;  // half a point's sign

// --- Axes

std::string tick_text(double value) {
    const double size = std::abs(value);
    return value != 0.0 && (size < 0.9e-3 || size >= 1e5) ? fmt::format("{:.0e}", value) : fmt::format("{:.3g}", value);
}

std::vector<AxisTick> log_ticks(double from, double to) {
    const double decades = std::log10(to / from);
    std::vector<double> digits = {1.0};
    if (decades <= 2.2) digits = {1.0, 2.0, 5.0};
    if (decades <= 0.9) digits = {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0};
    if (decades <= 0.3)
        digits = {1.0, 1.1, 1.2, 1.3, 1.4, 1.6, 1.8, 2.0, 2.3, 2.6, 3.0, 3.5, 4.0, 4.5, 5.0, 6.0, 7.0, 8.0, 9.0};
    const int step = decades <= 7.0 ? 1 : (decades <= 14.0 ? 2 : 4);
    std::vector<AxisTick> ticks;
    for (int decade = static_cast<int>(std::floor(std::log10(from))) - 4; std::pow(10.0, decade) <= to; ++decade) {
        if (decade % step != 0) continue;
        for (const double digit : digits) {
            const double value = digit * std::pow(10.0, decade);
            if (value >= from && value <= to) ticks.push_back({value, tick_text(value)});
        }
    }
    return ticks;
}

std::vector<AxisTick> linear_ticks(double from, double to) {
    const double rough = (to - from) / 5.0, decade = std::pow(10.0, std::floor(std::log10(rough)));
    double step = 10.0 * decade;
    for (const double digit : {5.0, 2.0, 1.0}) {
        if (digit * decade >= rough) step = digit * decade;
    }
    std::vector<AxisTick> ticks;
    for (double i = std::ceil(from / step); i * step <= to; ++i) ticks.push_back({i * step, tick_text(i * step)});
    return ticks;
}

/// All spreads, and some room.
AxisLayout axis_layout(const ChartAxis& axis, const ChartPanel& panel, Spread ChartPoint::*value) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const ChartPoint& point : panel.points) {
        for (const double number : {(point.*value).median, (point.*value).p25, (point.*value).p75}) {
            least = std::min(least, drawn(axis, number));
            most = std::max(most, drawn(axis, number));
        }
    }
    AxisLayout layout;
    if (axis.scale == AxisScale::log) {
        const double room = std::max(std::pow(most / least, 0.08), 1.08);
        layout.from = least / room;
        layout.to = most * room;
        layout.ticks = log_ticks(layout.from, layout.to);
    } else {
        const double room = most > least ? 0.08 * (most - least) : 0.5;
        layout.from = least >= 0.0 ? std::max(least - room, -0.02 * most) : least - room;
        layout.to = most + room;
        layout.ticks = linear_ticks(layout.from, layout.to);
    }
    return layout;
}

// --- Labels

PixelBox box_of(const PlacedLabel& label) {
    const double width = kCharacter_px * static_cast<double>(label.text.size());
    double x = label.x_px + 1.6 * kSign_px, y = label.y_px + label.shift_px;
    if (label.side == LabelSide::left) x = label.x_px - 1.6 * kSign_px - width;
    if (label.side == LabelSide::above || label.side == LabelSide::below) x = label.x_px - 0.5 * width;
    if (label.side == LabelSide::above) y -= 14.0;
    if (label.side == LabelSide::below) y += 14.0;
    return {x, y - 0.5 * kLabelHeight_px, x + width, y + 0.5 * kLabelHeight_px};
}

double overlap(const PixelBox& a, const PixelBox& b) {
    const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
    const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
    return width > 0.0 && height > 0.0 ? width * height : 0.0;
}

double outside(const PixelBox& box, const PixelBox& frame) {
    return std::max(frame.left - box.left, 0.0) + std::max(box.right - frame.right, 0.0) +
           std::max(frame.top - box.top, 0.0) + std::max(box.bottom - frame.bottom, 0.0);
}

bool is_same_place(const ChartPoint& a, const ChartPoint& b) {
    return a.x.median == b.x.median && a.y.median == b.y.median;
}

/// Of two points in one place one label is enough if it ends with the other: "auto: basis:4" tells that basis:4 is
/// there.
bool is_told_by_another(const ChartPanel& panel, std::size_t i) {
    for (std::size_t j = i + 1; j < panel.points.size(); ++j) {
        const ChartPoint &point = panel.points[i], &other = panel.points[j];
        if (is_same_place(point, other) && other.label.ends_with(point.label) && is_around_another(panel, j))
            return true;
    }
    return false;
}

/// Each label on that side of its point where it covers least of what is there already.
void place_labels(const ChartPanel& panel, PanelLayout& layout) {
    std::vector<PixelBox> taken;
    std::vector<std::array<double, 2>> places;
    for (const ChartPoint& point : panel.points) {
        const double x = layout.frame.left + (layout.frame.right - layout.frame.left) *
                                                 share_of(panel.x, layout.x, drawn(panel.x, point.x.median));
        const double y = layout.frame.bottom - (layout.frame.bottom - layout.frame.top) *
                                                   share_of(panel.y, layout.y, drawn(panel.y, point.y.median));
        places.push_back({x, y});
        taken.push_back({x - kSign_px, y - kSign_px, x + kSign_px, y + kSign_px});
    }
    for (std::size_t i = 0; i < panel.points.size(); ++i) {
        if (panel.points[i].label.empty() || is_told_by_another(panel, i)) continue;
        PlacedLabel best;
        double least = std::numeric_limits<double>::infinity();
        for (const int shift_px : {0, -6, 6, -13, 13, -20, 20, -27, 27}) {
            for (const LabelSide side : {LabelSide::right, LabelSide::left, LabelSide::above, LabelSide::below}) {
                const PlacedLabel label{places[i][0], places[i][1], side, shift_px, panel.points[i].label};
                const PixelBox box = box_of(label);
                double badness = 20.0 * outside(box, layout.frame) + 0.2 * std::abs(shift_px);
                for (const PixelBox& other : taken) badness += overlap(box, other);
                if (badness < least) {
                    least = badness;
                    best = label;
                }
            }
        }
        taken.push_back(box_of(best));
        layout.labels.push_back(best);
    }
}

// --- Around the panels

std::vector<std::string> wrapped(const std::string& text, std::size_t characters) {
    std::vector<std::string> lines;
    std::string rest = text;
    while (rest.size() > characters) {
        std::size_t at = rest.rfind(' ', characters);
        if (at == std::string::npos || at == 0) at = characters;
        lines.push_back(rest.substr(0, at));
        rest = rest.substr(std::min(at + 1, rest.size()));
    }
    if (!rest.empty()) lines.push_back(rest);
    return lines;
}

/// In columns as wide as the longest name needs; \returns where the lines end.
double lay_legend(const Chart& chart, double top, ChartLayout& layout) {
    const std::vector<std::string> series = series_of(chart);
    const bool all_labelled = std::all_of(chart.panels.begin(), chart.panels.end(), [](const ChartPanel& panel) {
        return std::all_of(panel.points.begin(), panel.points.end(),
                           [](const ChartPoint& point) { return point.label == point.series; });
    });
    if (series.size() < 2 || all_labelled) return top;
    std::size_t longest = 0;
    for (const std::string& name : series) longest = std::max(longest, name.size());
    const double column_px = kCharacter_px * static_cast<double>(longest) + 36.0;
    const double room_px = layout.width_px - 40.0;
    const auto columns = static_cast<std::size_t>(std::max(1.0, std::floor(room_px / column_px)));
    for (std::size_t i = 0; i < series.size(); ++i) {
        const std::size_t row = i / columns;
        layout.legend.push_back({30.0 + column_px * static_cast<double>(i % columns),
                                 top + kLegendLine_px * (static_cast<double>(row) + 0.5), series[i]});
    }
    const std::size_t rows = (series.size() + columns - 1) / columns;
    return top + kLegendLine_px * static_cast<double>(rows);
}

}  // namespace

std::vector<std::string> series_of(const Chart& chart) {
    std::vector<std::string> series;
    for (const ChartPanel& panel : chart.panels) {
        for (const ChartPoint& point : panel.points) {
            if (std::find(series.begin(), series.end(), point.series) == series.end()) series.push_back(point.series);
        }
    }
    return series;
}

double drawn(const ChartAxis& axis, double value) noexcept {
    return axis.least_drawn == 0.0 ? value : std::max(value, axis.least_drawn);
}

bool is_around_another(const ChartPanel& panel, std::size_t point) {
    if (panel.lines == SeriesLines::joined) return false;
    const ChartPoint& own = panel.points[point];
    return std::any_of(
        panel.points.begin(), panel.points.begin() + static_cast<std::ptrdiff_t>(point),
        [&](const ChartPoint& other) { return other.series != own.series && is_same_place(own, other); });
}

double share_of(const ChartAxis& axis, const AxisLayout& layout, double value) {
    if (axis.scale == AxisScale::linear) return (value - layout.from) / (layout.to - layout.from);
    return std::log(value / layout.from) / std::log(layout.to / layout.from);
}

ChartLayout layout_of(const Chart& chart) {
    ChartLayout layout;
    layout.note_lines = wrapped(chart.note, 135);
    double top = kTitleHeight_px + kNoteLine_px * static_cast<double>(layout.note_lines.size()) + 4.0;

    // Panels, one or two in a row
    const std::size_t columns = chart.panels.size() == 1 ? 1 : 2;
    const double width = static_cast<double>(layout.width_px) / static_cast<double>(columns);
    const double height = columns == 1 ? kTallPanelHeight_px : kPanelHeight_px;
    for (std::size_t i = 0; i < chart.panels.size(); ++i) {
        const ChartPanel& panel = chart.panels[i];
        const std::size_t row = i / columns;
        const double left = width * static_cast<double>(i % columns), y = top + height * static_cast<double>(row);
        PanelLayout& of_panel = layout.panels.emplace_back();
        of_panel.frame = {left + kLeft_px, y + kAbove_px, left + width - kRight_px, y + height - kBelow_px};
        of_panel.x = axis_layout(panel.x, panel, &ChartPoint::x);
        of_panel.y = axis_layout(panel.y, panel, &ChartPoint::y);
        place_labels(panel, of_panel);
    }
    const std::size_t rows = (chart.panels.size() + columns - 1) / columns;
    top += height * static_cast<double>(rows);

    // What the signs mean
    top = lay_legend(chart, top, layout);
    const bool has_front = std::any_of(chart.panels.begin(), chart.panels.end(), [](const ChartPanel& panel) {
        return std::any_of(panel.points.begin(), panel.points.end(),
                           [](const ChartPoint& point) { return point.on_front; });
    });
    if (has_front) {
        layout.front_note_y_px = top + 0.5 * kLegendLine_px;
        top += kLegendLine_px;
    }
    layout.height_px = static_cast<int>(std::ceil(top + 6.0));
    return layout;
}

}  // namespace emulsion
