#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "chart/chart_layout.h"
#include "chart/gnuplot.h"

namespace emulsion {

namespace {

// Okabe & Ito's, but for yellow, which is too bright for white paper.
constexpr std::array kColours = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"};
// gnuplot's numbers of hollow signs; the filled one is the next.
constexpr std::array kSigns = {6, 4, 8, 12, 10, 14};
/// A circle that leaves room for another sign in it.
constexpr std::string_view kRing = "pt 6 ps 1.9 lw 1.8";

/// In single quotes nothing is special to gnuplot but those, and not even doubled ones everywhere: they become
/// apostrophes.
std::string in_quotes(std::string_view text) {
    std::string result = "'";
    for (const char c : text) {
        if (c == '\'') {
            result += "\u2019";
        } else {
            result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
        }
    }
    return result + "'";
}

class ScriptWriter {
  public:
    ScriptWriter(const Chart& chart, ChartFormat format)
        : chart_(chart), format_(format), layout_(layout_of(chart)), series_(series_of(chart)) {}

    std::string write() {
        write_head();
        for (std::size_t i = 0; i < chart_.panels.size(); ++i) write_data(i);
        text_ += "set multiplot\n";
        write_texts();
        for (std::size_t i = 0; i < chart_.panels.size(); ++i) write_panel(i);
        text_ += "unset multiplot\n";
        return std::move(text_);
    }

  private:
    template <class... Args>
    void add(fmt::format_string<Args...> format, Args&&... args) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
    }

    [[nodiscard]] std::string screen(double x_px, double y_px) const {
        return fmt::format("screen {:.5f},{:.5f}", x_px / layout_.width_px, 1.0 - y_px / layout_.height_px);
    }
    [[nodiscard]] std::size_t number_of(const std::string& series) const {
        return static_cast<std::size_t>(std::find(series_.begin(), series_.end(), series) - series_.begin());
    }
    [[nodiscard]] const char* colour(std::size_t series) const { return kColours[series % kColours.size()]; }
    [[nodiscard]] int sign(std::size_t series) const { return kSigns[series % kSigns.size()]; }

    [[nodiscard]] bool is_only_rings(std::size_t series) const {
        return std::all_of(chart_.panels.begin(), chart_.panels.end(), [&](const ChartPanel& panel) {
            for (std::size_t i = 0; i < panel.points.size(); ++i) {
                if (panel.points[i].series == series_[series] && !is_around_another(panel, i)) return false;
            }
            return true;
        });
    }

    void write_head() {
        add("set encoding utf8\n");
        if (format_ == ChartFormat::svg) {
            add("set terminal svg noenhanced size {},{} font 'sans-serif,12' background '#ffffff'\n", layout_.width_px,
                layout_.height_px);
        } else {
            add("set terminal pngcairo noenhanced size {},{} font 'sans-serif,9' background '#ffffff'\n",
                layout_.width_px, layout_.height_px);
        }
    }

    // --- Data: of panel p and series s, $P<p>S<s>F for points on the front, $P<p>S<s>N for the others, R for rings
    // around other points, A for all of them, and B for those with bars

    static std::string block_name(std::size_t p, std::size_t s, char kind) {
        return fmt::format("$P{}S{}{}", p, s, kind);
    }
    static std::string front_name(std::size_t p) { return fmt::format("$P{}FRONT", p); }

    void add_block(const std::string& name, const std::string& rows) {
        if (rows.empty()) return;
        add("{} << EOD\n{}EOD\n", name, rows);
        blocks_.insert(name);
    }

    static void append_point(std::string& rows, const ChartPanel& panel, const ChartPoint& point) {
        const auto x = [&](double value) { return drawn(panel.x, value); };
        const auto y = [&](double value) { return drawn(panel.y, value); };
        rows += fmt::format("{} {} {} {} {} {}\n", x(point.x.median), y(point.y.median), x(point.x.p25), x(point.x.p75),
                            y(point.y.p25), y(point.y.p75));
    }

    /// Whether its bars come out from under the sign; most don't, and would be a large part of the file.
    [[nodiscard]] bool has_bars(std::size_t p, const ChartPoint& point) const {
        constexpr double kLeast_px = 10.0;
        const PanelLayout& panel = layout_.panels[p];
        const auto length = [](const ChartAxis& axis, const AxisLayout& layout, const Spread& value) {
            return std::abs(share_of(axis, layout, drawn(axis, value.p75)) -
                            share_of(axis, layout, drawn(axis, value.p25)));
        };
        return length(chart_.panels[p].x, panel.x, point.x) * (panel.frame.right - panel.frame.left) > kLeast_px ||
               length(chart_.panels[p].y, panel.y, point.y) * (panel.frame.bottom - panel.frame.top) > kLeast_px;
    }

    void write_data(std::size_t p) {
        const ChartPanel& panel = chart_.panels[p];
        std::vector<ChartPoint> front;
        for (std::size_t s = 0; s < series_.size(); ++s) {
            std::string on, off, rings, all, bars;
            for (std::size_t i = 0; i < panel.points.size(); ++i) {
                const ChartPoint& point = panel.points[i];
                if (point.series != series_[s]) continue;
                append_point(all, panel, point);
                if (is_around_another(panel, i)) {
                    append_point(rings, panel, point);
                    continue;
                }
                if (has_bars(p, point)) append_point(bars, panel, point);
                append_point(point.on_front ? on : off, panel, point);
                if (point.on_front) front.push_back(point);
            }
            for (const auto& [kind, rows] : {std::pair('F', &on), std::pair('N', &off), std::pair('R', &rings),
                                             std::pair('A', &all), std::pair('B', &bars)}) {
                add_block(block_name(p, s, kind), *rows);
            }
        }
        if (front.empty()) return;
        std::stable_sort(front.begin(), front.end(),
                         [](const ChartPoint& a, const ChartPoint& b) { return a.x.median < b.x.median; });
        std::string rows;
        for (const ChartPoint& point : front) append_point(rows, panel, point);
        add_block(front_name(p), rows);
    }

    // --- What stands around the panels; drawn with the first of them

    void write_texts() {
        add("set label {} at {} left font ',{}'\n", in_quotes(chart_.title), screen(16.0, 18.0), title_size());
        for (std::size_t i = 0; i < layout_.note_lines.size(); ++i) {
            add("set label {} at {} left textcolor rgb '#555555'\n", in_quotes(layout_.note_lines[i]),
                screen(16.0, 42.0 + 17.0 * static_cast<double>(i)));
        }
        for (const LegendEntry& entry : layout_.legend) {
            const std::size_t s = number_of(entry.series);
            const std::string drawn_as =
                is_only_rings(s) ? std::string(kRing) : fmt::format("pt {} ps 1 lw 1.5", sign(s) + 1);
            add("set label {} at {} left offset 1.2,0 point {} lc rgb '{}'\n", in_quotes(entry.series),
                screen(entry.x_px, entry.y_px), drawn_as, colour(s));
        }
        if (layout_.front_note_y_px > 0.0) {
            add("set label 'Filled, on the dashed line: Pareto front, nothing measured is both cheaper and better. "
                "Bars: p25 to p75.' "
                "at {} left textcolor rgb '#555555'\n",
                screen(22.0, layout_.front_note_y_px));
        }
    }
    [[nodiscard]] int title_size() const { return format_ == ChartFormat::svg ? 16 : 12; }

    // --- Panels

    void write_axis(char axis, const ChartAxis& meaning, const AxisLayout& layout) {
        add("{} logscale {}\n", meaning.scale == AxisScale::log ? "set" : "unset", axis);
        add("set {}range [{}:{}]\n", axis, layout.from, layout.to);
        add("set {}label {} offset {}\n", axis,
            in_quotes(meaning.unit.empty() ? meaning.label : meaning.label + " (" + meaning.unit + ")"),
            axis == 'x' ? "0,0.3" : "0.5,0");
        std::string ticks;
        for (const AxisTick& tick : layout.ticks) {
            ticks += fmt::format("{}{} {}", ticks.empty() ? "" : ", ", in_quotes(tick.text), tick.value);
        }
        add("set {}tics nomirror ({})\n", axis, ticks);
    }

    void write_labels(const PanelLayout& layout) {
        for (const PlacedLabel& label : layout.labels) {
            double x_px = label.x_px, y_px = label.y_px + label.shift_px;
            std::string_view align = "center";
            if (label.side == LabelSide::right) {
                x_px += 8.0;
                align = "left";
            } else if (label.side == LabelSide::left) {
                x_px -= 8.0;
                align = "right";
            } else {
                y_px += label.side == LabelSide::above ? -14.0 : 14.0;
            }
            add("set label {} at {} {} font ',{}' front\n", in_quotes(label.text), screen(x_px, y_px), align,
                format_ == ChartFormat::svg ? 11 : 8);
        }
    }

    void write_panel(std::size_t p) {
        const ChartPanel& panel = chart_.panels[p];
        const PanelLayout& layout = layout_.panels[p];
        const double w = layout_.width_px, h = layout_.height_px;
        add("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n", layout.frame.left / w,
            layout.frame.right / w);
        add("set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n", 1.0 - layout.frame.top / h,
            1.0 - layout.frame.bottom / h);
        add("set border 3 lc rgb '#555555'\nunset key\nset bars 0\n");
        add("set title {} offset 0,-0.4\n", in_quotes(panel.title));
        write_axis('x', panel.x, layout.x);
        write_axis('y', panel.y, layout.y);
        write_labels(layout);

        std::vector<std::string> plots;
        if (blocks_.contains(front_name(p))) {
            plots.push_back(front_name(p) + " with lines lc rgb '#777777' dt 2 lw 1.5");
        }
        for (std::size_t s = 0; s < series_.size(); ++s) append_series(panel, p, s, plots);
        add("plot {}\nunset label\n", fmt::join(plots, ", \\\n  "));
    }

    void append_series(const ChartPanel& panel, std::size_t p, std::size_t s, std::vector<std::string>& plots) const {
        const auto plot = [&](char kind, const std::string& style) {
            const std::string name = block_name(p, s, kind);
            if (blocks_.contains(name)) plots.push_back(fmt::format("{} with {} lc rgb '{}'", name, style, colour(s)));
        };
        if (panel.lines == SeriesLines::joined) plot('A', "lines lw 1");
        plot('B', "xyerrorbars pt -1 lw 1");
        plot('N', fmt::format("points pt {} ps 0.9 lw 1.5", sign(s)));
        plot('F', fmt::format("points pt {} ps 1.1", sign(s) + 1));
        plot('R', fmt::format("points {}", kRing));
    }

    const Chart& chart_;
    ChartFormat format_;
    ChartLayout layout_;
    std::vector<std::string> series_;
    std::set<std::string> blocks_ = {};  ///< those that there are
    std::string text_ = {};
};

}  // namespace

std::string gnuplot_script(const Chart& chart, ChartFormat format) {
    validate(chart);
    return ScriptWriter(chart, format).write();
}

}  // namespace emulsion
