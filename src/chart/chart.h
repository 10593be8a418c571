#pragma once
// A chart as a plain value: what was measured, and what its axes mean. chart_csv.h writes and reads it, gnuplot.h draws
// it, and charts.h has those that measure their points.
//
// Times are ratios to a baseline that was measured alternately with them, so that a busy machine slows both; errors are
// against a reference that the chart's note names.

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace emulsion {

/// Repeated measurements in three numbers: the median, and the quartiles below and above it.
struct Spread {
    double median = 0.0, p25 = 0.0, p75 = 0.0;
    bool operator==(const Spread&) const = default;
};

/// By linear interpolation between the values in order. \throws std::invalid_argument if there are none.
[[nodiscard]] Spread spread_of(std::vector<double> values);
/// Of a number without spread.
[[nodiscard]] constexpr Spread exactly(double value) noexcept { return {value, value, value}; }

enum class AxisScale { linear, log };
/// Which end of an axis is the better one. An axis with neither has no part in the Pareto front.
enum class BetterEnd { low, high, neither };

struct ChartAxis {
    std::string label = {};
    std::string unit = {};  ///< empty: a ratio, or the label says it
    AxisScale scale = AxisScale::log;
    BetterEnd better = BetterEnd::low;
    /// What is less is drawn here, as errors of 0 have no place on a logarithmic axis; > 0 there. 0: nothing is less.
    double least_drawn = 0.0;
    bool operator==(const ChartAxis&) const = default;
};

struct ChartPoint {
    std::string series = {};  ///< what has one colour and one sign
    std::string label = {};   ///< beside the point; empty: the legend says enough
    Spread x = {}, y = {};
    bool on_front = false;                                     ///< mark_front() finds it
    std::vector<std::pair<std::string, double>> details = {};  ///< what else was measured: "Mpix/s", ...; CSV only
    bool operator==(const ChartPoint&) const = default;
};

/// Whether the points of a series are joined, in their order.
enum class SeriesLines { none, joined };

/// One diagram of a chart.
struct ChartPanel {
    std::string title = {};
    ChartAxis x = {}, y = {};
    SeriesLines lines = SeriesLines::none;
    std::vector<ChartPoint> points = {};
    bool operator==(const ChartPanel&) const = default;
};

struct Chart {
    std::string name = {};   ///< as on the command line
    std::string title = {};  ///< one line
    std::string note = {};   ///< one line: baseline, reference, sizes
    std::vector<ChartPanel> panels = {};
    bool operator==(const Chart&) const = default;
};

/// Marks the points to which no other is preferable: the Pareto front, by medians. A point is off it if another is no
/// worse on both axes and better on one; two of the same place are both on it.
void mark_front(ChartPanel& panel);

/// The exponent e of y = c x^e by least squares on the logarithms. \throws std::invalid_argument unless there are as
/// many x as y, all above 0, and at least two different x.
[[nodiscard]] double fitted_exponent(std::span<const double> x, std::span<const double> y);

/// The exponent of a series of a panel, from the medians. \throws std::invalid_argument likewise.
[[nodiscard]] double fitted_exponent(const ChartPanel& panel, std::string_view series);

/// The number of that name; NaN if the point has none.
[[nodiscard]] double detail(const ChartPoint& point, std::string_view name);

/// \throws std::invalid_argument if there is no panel, two have the same title, a panel has no points, a number is not
/// finite, or one that is drawn on a logarithmic axis is not above 0.
void validate(const Chart& chart);

}  // namespace emulsion
