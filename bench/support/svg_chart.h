#pragma once
// A line chart as SVG, for docs: x logarithmic, y linear from 0, each line named at its right end.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace emulsion {

/// The line goes through (x, y); a bar reaches from there to `bar_end`.
struct ChartPoint {
    double x = 1.0;  ///< > 0
    double y = 0.0, bar_end = 0.0;
};

struct ChartSeries {
    std::string name;
    std::vector<ChartPoint> points;  ///< at least one
};

/// Texts are taken as they are: no `<` or `&`.
struct Chart {
    std::string title, x_label, y_label;
    std::vector<double> x_ticks;  ///< rising, at least two; the first and the last are the ends of the axis
    std::vector<ChartSeries> series;
};

namespace svg_chart {

inline constexpr double kWidth = 800.0, kHeight = 460.0;
inline constexpr double kLeft = 70.0, kRight = 640.0, kTop = 56.0, kBottom = 400.0;

/// Of equal lightness more or less, and told apart by the colour-blind (Okabe & Ito's palette); past five they repeat.
inline const char* color_of(std::size_t number) {
    constexpr const char* kColors[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#8a6d00"};
    return kColors[number % std::size(kColors)];
}

/// 1, 2 or 5 times a power of ten, so that 4 to 10 of them reach `most`.
inline double tick_step(double most) {
    const double power = std::pow(10.0, std::floor(std::log10(most / 4.0)));
    for (const double factor : {5.0, 2.0}) {
        if (most / (factor * power) >= 4.0) return factor * power;
    }
    return power;
}

/// Moved apart, so that none is closer than `distance` to the next; in the order given by their values.
inline std::vector<double> spread(const std::vector<double>& places, double distance) {
    std::vector<std::size_t> order(places.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return places[a] > places[b]; });
    std::vector<double> moved = places;
    for (std::size_t i = 1; i < order.size(); ++i) {
        moved[order[i]] = std::min(moved[order[i]], moved[order[i - 1]] - distance);
    }
    return moved;
}

/// Where numbers come to lie.
struct Axes {
    double x_least, x_most, y_most;
    [[nodiscard]] double x(double value) const {
        return kLeft + (kRight - kLeft) * std::log(value / x_least) / std::log(x_most / x_least);
    }
    [[nodiscard]] double y(double value) const { return kBottom - (kBottom - kTop) * value / y_most; }
};

inline std::string grid(const Chart& chart, const Axes& axes, double step) {
    std::string svg;
    for (double value = 0.0; value <= axes.y_most * 1.0001; value += step) {
        svg += fmt::format("<path d=\"M{} {:.1f}H{}\" stroke=\"#ddd\"/>\n", kLeft, axes.y(value), kRight);
        svg += fmt::format("<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{:g}</text>\n", kLeft - 8.0,
                           axes.y(value) + 4.0, value);
    }
    for (const double value : chart.x_ticks) {
        svg += fmt::format("<path d=\"M{:.1f} {}V{}\" stroke=\"#ddd\"/>\n", axes.x(value), kTop, kBottom);
        svg += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{:g}</text>\n", axes.x(value),
                           kBottom + 18.0, value);
    }
    return svg;
}

inline std::string line(const ChartSeries& series, const Axes& axes, const char* color, double label_y) {
    std::string svg, path;
    for (const ChartPoint& point : series.points) {
        const double x = axes.x(point.x), y = axes.y(point.y);
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x, y);
        svg += fmt::format("<path d=\"M{:.1f} {:.1f}V{:.1f}\" stroke=\"{}\" stroke-width=\"1.5\"/>\n", x,
                           axes.y(point.y), axes.y(point.bar_end), color);
        svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"{}\"/>\n", x, y, color);
    }
    svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n", path, color);
    svg += fmt::format("<text x=\"{}\" y=\"{:.1f}\" fill=\"{}\" font-weight=\"bold\">{}</text>\n", kRight + 12.0,
                       label_y + 4.0, color, series.name);
    return svg;
}

}  // namespace svg_chart

inline std::string to_svg(const Chart& chart) {
    using namespace svg_chart;  // NOLINT(google-build-using-namespace): its own parts
    double most = 0.0;
    for (const ChartSeries& series : chart.series) {
        for (const ChartPoint& point : series.points) most = std::max({most, point.y, point.bar_end});
    }
    const double step = tick_step(most);
    const Axes axes{chart.x_ticks.front(), chart.x_ticks.back(), step * std::ceil(most / step)};
    std::vector<double> ends;
    for (const ChartSeries& series : chart.series) ends.push_back(axes.y(series.points.back().y));
    ends = spread(ends, 18.0);

    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
        "font-family=\"sans-serif\" font-size=\"14\" fill=\"#222\">\n<rect width=\"{0}\" height=\"{1}\" "
        "fill=\"#fff\"/>\n<text x=\"{2}\" y=\"28\" font-size=\"16\" font-weight=\"bold\">{3}</text>\n",
        kWidth, kHeight, kLeft, chart.title);
    svg += grid(chart, axes, step);
    svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", 0.5 * (kLeft + kRight),
                       kBottom + 44.0, chart.x_label);
    svg += fmt::format("<text transform=\"translate(22 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                       0.5 * (kTop + kBottom), chart.y_label);
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
        svg += line(chart.series[i], axes, color_of(i), ends[i]);
    }
    return svg + "</svg>\n";
}

}  // namespace emulsion
