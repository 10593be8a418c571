#include "chart/chart.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace emulsion {

namespace {

double quantile(const std::vector<double>& sorted, double share) {
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

/// So that less is better.
double cost(const ChartAxis& axis, const Spread& value) {
    if (axis.better == BetterEnd::neither) return 0.0;
    return axis.better == BetterEnd::low ? value.median : -value.median;
}

void validate(const std::string& chart, const ChartAxis& axis, const Spread& value, const std::string& point) {
    const auto refuse = [&](const char* reason) {
        throw std::invalid_argument(fmt::format("chart {}: {} of {} {}", chart, axis.label, point, reason));
    };
    for (const double number : {value.median, value.p25, value.p75}) {
        if (!std::isfinite(number)) refuse("is not finite");
        if (axis.scale == AxisScale::log && !(std::max(number, axis.least_drawn) > 0.0)) {
            refuse("is not above 0, and its axis is logarithmic");
        }
    }
}

}  // namespace

Spread spread_of(std::vector<double> values) {
    if (values.empty()) throw std::invalid_argument("spread: expected at least one value");
    std::sort(values.begin(), values.end());
    return {quantile(values, 0.5), quantile(values, 0.25), quantile(values, 0.75)};
}

void mark_front(ChartPanel& panel) {
    const auto beats = [&panel](const ChartPoint& a, const ChartPoint& b) {
        const double ax = cost(panel.x, a.x), ay = cost(panel.y, a.y), bx = cost(panel.x, b.x), by = cost(panel.y, b.y);
        return ax <= bx && ay <= by && (ax < bx || ay < by);
    };
    for (ChartPoint& point : panel.points) {
        point.on_front = std::none_of(panel.points.begin(), panel.points.end(),
                                      [&](const ChartPoint& other) { return beats(other, point); });
    }
}

double fitted_exponent(std::span<const double> x, std::span<const double> y) {
    const auto is_positive = [](double value) { return std::isfinite(value) && value > 0.0; };
    const bool usable = x.size() == y.size() && std::all_of(x.begin(), x.end(), is_positive) &&
                        std::all_of(y.begin(), y.end(), is_positive) &&
                        std::any_of(x.begin(), x.end(), [&](double value) { return value != x.front(); });
    if (!usable) {
        throw std::invalid_argument("exponent: expected as many x as y, all above 0, and at least two different x");
    }
    const auto n = static_cast<double>(x.size());
    double mean_x = 0.0, mean_y = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean_x += std::log(x[i]) / n;
        mean_y += std::log(y[i]) / n;
    }
    double xx = 0.0, xy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double dx = std::log(x[i]) - mean_x;
        xx += dx * dx;
        xy += dx * (std::log(y[i]) - mean_y);
    }
    return xy / xx;
}

double fitted_exponent(const ChartPanel& panel, std::string_view series) {
    std::vector<double> x, y;
    for (const ChartPoint& point : panel.points) {
        if (point.series != series) continue;
        x.push_back(point.x.median);
        y.push_back(point.y.median);
    }
    return fitted_exponent(x, y);
}

double detail(const ChartPoint& point, std::string_view name) {
    for (const auto& [key, value] : point.details) {
        if (key == name) return value;
    }
    return std::numeric_limits<double>::quiet_NaN();
}

void validate(const Chart& chart) {
    if (chart.panels.empty()) throw std::invalid_argument("chart " + chart.name + ": expected a panel");
    for (const ChartPanel& panel : chart.panels) {
        if (panel.points.empty()) {
            throw std::invalid_argument("chart " + chart.name + ": panel \"" + panel.title + "\" has no points");
        }
        const auto same = std::count_if(chart.panels.begin(), chart.panels.end(),
                                        [&](const ChartPanel& other) { return other.title == panel.title; });
        if (same > 1) {
            throw std::invalid_argument("chart " + chart.name + ": two panels have the title \"" + panel.title + "\"");
        }
        for (const ChartPoint& point : panel.points) {
            const std::string what = point.series + " " + point.label;
            validate(chart.name, panel.x, point.x, what);
            validate(chart.name, panel.y, point.y, what);
        }
    }
}

}  // namespace emulsion
