#pragma once
// Where the parts of a chart lie on its picture. In pixels from the upper left corner.

#include <cstddef>
#include <string>
#include <vector>

#include "chart/chart.h"

namespace emulsion {

struct PixelBox {
    double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
};

/// A number on an axis, and how it is written.
struct AxisTick {
    double value = 0.0;
    std::string text;
};

struct AxisLayout {
    double from = 0.0, to = 1.0;
    std::vector<AxisTick> ticks;
};

enum class LabelSide { right, left, above, below };

/// A point's label; the place is that of the point.
struct PlacedLabel {
    double x_px = 0.0, y_px = 0.0;
    LabelSide side = LabelSide::right;
    int shift_px = 0;  ///< down from beside the point
    std::string text;
};

struct PanelLayout {
    PixelBox frame;  ///< of the axes
    AxisLayout x, y;
    std::vector<PlacedLabel> labels;
};

struct LegendEntry {
    double x_px = 0.0, y_px = 0.0;  ///< of the sign
    std::string series;
};

struct ChartLayout {
    int width_px = 900, height_px = 0;
    std::vector<std::string> note_lines;
    std::vector<PanelLayout> panels;
    std::vector<LegendEntry> legend;  ///< empty if labels say all
    double front_note_y_px = 0.0;     ///< 0: no point is on a front
};

/// Names of series, each once, in the order of the points.
[[nodiscard]] std::vector<std::string> series_of(const Chart& chart);

/// The coordinate that is drawn: at least the axis's least_drawn.
[[nodiscard]] double drawn(const ChartAxis& axis, double value) noexcept;

/// Whether a point lies at the very place of an earlier one of another series. It is drawn as a ring around that, which
/// its sign would hide. Not where points are joined: their lines tell enough.
[[nodiscard]] bool is_around_another(const ChartPanel& panel, std::size_t point);

/// Where a value lies on its axis: 0 at `from`, 1 at `to`.
[[nodiscard]] double share_of(const ChartAxis& axis, const AxisLayout& layout, double value);

/// \param chart as validate() wants it
[[nodiscard]] ChartLayout layout_of(const Chart& chart);

}  // namespace emulsion
