#include "chart/chart_csv.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/error.h"

namespace emulsion {

namespace {

using Row = std::vector<std::string>;

constexpr std::string_view kColumns = "panel,series,label,x,x_p25,x_p75,y,y_p25,y_p75,front,details";
constexpr std::size_t kColumnCount = 11, kChartCells = 4, kPanelCells = 15;

// --- Writing

std::string cell(std::string_view text) {
    if (text.find_first_of(",\"\n\r") == std::string_view::npos && !text.starts_with('#')) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

std::string line(const Row& row) {
    std::string text;
    for (const std::string& value : row) text += (&value == row.data() ? "" : ",") + cell(value);
    return text + '\n';
}

template <class T>
using Words = std::span<const std::pair<const char*, T>>;

constexpr std::array<std::pair<const char*, AxisScale>, 2> kScales = {
    {{"linear", AxisScale::linear}, {"log", AxisScale::log}}};
constexpr std::array<std::pair<const char*, BetterEnd>, 3> kBetterEnds = {
    {{"low", BetterEnd::low}, {"high", BetterEnd::high}, {"neither", BetterEnd::neither}}};

constexpr std::array<std::pair<const char*, SeriesLines>, 2> kSeriesLines = {
    {{"joined", SeriesLines::joined}, {"none", SeriesLines::none}}};
constexpr std::array<std::pair<const char*, bool>, 2> kOnFront = {{{"0", false}, {"1", true}}};

template <class T>
const char* word_of(T value, Words<T> words) {
    return std::ranges::find(words, value, &std::pair<const char*, T>::second)->first;
}

void append_axis(Row& row, std::string_view name, const ChartAxis& axis) {
    row.insert(row.end(), {std::string(name), axis.label, axis.unit, word_of<AxisScale>(axis.scale, kScales),
                           word_of<BetterEnd>(axis.better, kBetterEnds), fmt::format("{}", axis.least_drawn)});
}

void append_spread(Row& row, const Spread& value) {
    for (const double number : {value.median, value.p25, value.p75}) row.push_back(fmt::format("{}", number));
}

std::string details_text(const ChartPoint& point) {
    std::string text;
    for (const auto& [name, value] : point.details) {
        text += fmt::format("{}{}={}", text.empty() ? "" : ";", name, value);
    }
    return text;
}

// --- Reading

/// A text taken apart by its commas, quotes and line breaks.
class CsvReader {
  public:
    CsvReader(std::string_view text, std::filesystem::path name) : text_(text), name_(std::move(name)) {}

    [[nodiscard]] bool at_end() const { return at_ == text_.size(); }

    [[noreturn]] void fail(const std::string& reason) const {
        throw IoError(name_, fmt::format("line {}: {}", line_, reason));
    }

    /// The next row; the break behind it may be of either kind.
    Row next() {
        ++line_;
        Row row(1);
        while (!at_end()) {
            const char c = text_[at_++];
            if (c == '\n') return row;
            if (c == '\r' && !at_end() && text_[at_] == '\n') continue;
            if (c == ',') {
                row.emplace_back();
            } else if (c == '"' && row.back().empty()) {
                read_quoted(row.back());
            } else {
                row.back() += c;
            }
        }
        return row;
    }

    [[nodiscard]] double number(std::string_view text) const {
        double value = 0.0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size()) {
            fail(fmt::format("found \"{}\", expected a number", text));
        }
        return value;
    }

  private:
    void read_quoted(std::string& value) {
        while (!at_end()) {
            const char c = text_[at_++];
            if (c != '"') {
                value += c;
            } else if (!at_end() && text_[at_] == '"') {
                value += text_[at_++];
            } else {
                return;
            }
        }
        fail("a quote that is not closed");
    }

    std::string_view text_;
    std::filesystem::path name_;
    std::size_t at_ = 0;
    int line_ = 0;
};

template <class T>
T choice(const CsvReader& reader, const std::string& text, Words<T> words) {
    std::string expected;
    for (const auto& [word, value] : words) {
        if (text == word) return value;
        expected += (expected.empty() ? "" : " or ") + std::string(word);
    }
    reader.fail(fmt::format("found \"{}\", expected {}", text, expected));
}

ChartAxis axis_of(const CsvReader& reader, const Row& row, std::size_t first) {
    return {row[first + 1], row[first + 2], choice<AxisScale>(reader, row[first + 3], kScales),
            choice<BetterEnd>(reader, row[first + 4], kBetterEnds), reader.number(row[first + 5])};
}

void read_details(const CsvReader& reader, std::string_view text, ChartPoint& point) {
    while (!text.empty()) {
        const std::string_view one = text.substr(0, text.find(';'));
        const std::size_t equals = one.rfind('=');
        if (equals == std::string_view::npos) reader.fail(fmt::format("found \"{}\", expected NAME=NUMBER", one));
        point.details.emplace_back(one.substr(0, equals), reader.number(one.substr(equals + 1)));
        text.remove_prefix(std::min(one.size() + 1, text.size()));
    }
}

ChartPoint point_of(const CsvReader& reader, const Row& row) {
    const auto spread = [&](std::size_t i) {
        return Spread{reader.number(row[i]), reader.number(row[i + 1]), reader.number(row[i + 2])};
    };
    ChartPoint point{.series = row[1],
                     .label = row[2],
                     .x = spread(3),
                     .y = spread(6),
                     .on_front = choice<bool>(reader, row[9], kOnFront)};
    read_details(reader, row[10], point);
    return point;
}

}  // namespace

std::string to_csv(const Chart& chart) {
    std::string text = "# chart," + line({chart.name, chart.title, chart.note});
    for (const ChartPanel& panel : chart.panels) {
        Row row = {panel.title};
        append_axis(row, "x", panel.x);
        append_axis(row, "y", panel.y);
        row.emplace_back(word_of<SeriesLines>(panel.lines, kSeriesLines));
        text += "# panel," + line(row);
    }
    text += std::string(kColumns) + '\n';
    for (const ChartPanel& panel : chart.panels) {
        for (const ChartPoint& point : panel.points) {
            Row row = {panel.title, point.series, point.label};
            append_spread(row, point.x);
            append_spread(row, point.y);
            row.insert(row.end(), {word_of<bool>(point.on_front, kOnFront), details_text(point)});
            text += line(row);
        }
    }
    return text;
}

Chart parse_chart_csv(const std::string& text, const std::filesystem::path& name) {
    CsvReader reader(text, name);
    Chart chart;
    Row row = reader.next();
    if (row.size() != kChartCells || row[0] != "# chart") reader.fail("expected # chart,NAME,TITLE,NOTE");
    chart.name = row[1];
    chart.title = row[2];
    chart.note = row[3];
    for (row = reader.next(); row[0] == "# panel"; row = reader.next()) {
        if (row.size() != kPanelCells) reader.fail(fmt::format("expected {} cells of a panel", kPanelCells));
        chart.panels.push_back({row[1],
                                axis_of(reader, row, 2),
                                axis_of(reader, row, 8),
                                choice<SeriesLines>(reader, row[14], kSeriesLines),
                                {}});
    }
    if (line(row) != std::string(kColumns) + '\n') reader.fail("expected " + std::string(kColumns));
    while (!reader.at_end()) {
        row = reader.next();
        if (row.size() != kColumnCount) reader.fail(fmt::format("expected {} cells of a point", kColumnCount));
        const auto panel = std::find_if(chart.panels.begin(), chart.panels.end(),
                                        [&](const ChartPanel& candidate) { return candidate.title == row[0]; });
        if (panel == chart.panels.end()) reader.fail(fmt::format("there is no panel \"{}\"", row[0]));
        panel->points.push_back(point_of(reader, row));
    }
    return chart;
}

}  // namespace emulsion
