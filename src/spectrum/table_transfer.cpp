#include "spectrum/table_transfer.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>

#include "core/error.h"
#include "core/parameters.h"
#include "core/text_file.h"
#include "spectrum/odd_extension.h"

namespace emulsion {

namespace {

/// Along the straight line through two points, exactly at both of them, monotone between; y from x or the reverse.
double along(double x0, double x1, double y0, double y1, double x) noexcept {
    const double t = (x - x0) / (x1 - x0);
    if (t <= 1.0) return std::lerp(y0, y1, t);
    return y1 + (y1 - y0) / (x1 - x0) * (x - x1);
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlanks = " \t\r";
    const std::size_t first = text.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::optional<double> number(std::string_view cell) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value)) return {};
    return value;
}

[[noreturn]] void fail(int line, const std::string& problem) {
    throw std::invalid_argument("line " + std::to_string(line) + ": " + problem);
}

std::string quoted(std::string_view text) { return '"' + std::string(text) + '"'; }

/// A row after those in `points`.
TablePoint read_row(int line, std::string_view code_cell, std::string_view luminance_cell,
                    const std::vector<TablePoint>& points) {
    const std::optional<double> code = number(code_cell), luminance = number(luminance_cell);
    if (!code) fail(line, "code is " + quoted(code_cell) + ", expected a finite number");
    if (!luminance) fail(line, "luminance is " + quoted(luminance_cell) + ", expected a finite number");
    if (points.empty()) return {*code, *luminance};
    if (!(*code > points.back().x)) {
        fail(line, "code is " + std::string(code_cell) + ", expected more than " + number_text(points.back().x));
    }
    if (*luminance < points.back().y) {
        fail(line, "luminance is " + std::string(luminance_cell) + ", expected " + number_text(points.back().y) +
                       " or more, as curves don't fall");
    }
    return {*code, *luminance};
}

std::vector<TablePoint> read_rows(std::string_view csv) {
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (csv.substr(0, kByteOrderMark.size()) == kByteOrderMark) csv.remove_prefix(kByteOrderMark.size());
    std::vector<TablePoint> points;
    bool first = true;
    int line = 0;
    while (!csv.empty()) {
        const std::size_t end = std::min(csv.find('\n'), csv.size());
        const std::string_view row = trimmed(csv.substr(0, end));
        csv.remove_prefix(std::min(end + 1, csv.size()));
        ++line;
        if (row.empty() || row.front() == '#') continue;
        const std::size_t comma = row.find(',');
        if (comma == std::string_view::npos || row.find(',', comma + 1) != std::string_view::npos) {
            fail(line, quoted(row) + ", expected two cells with a comma between: code, luminance");
        }
        const std::string_view code = trimmed(row.substr(0, comma)), luminance = trimmed(row.substr(comma + 1));
        const bool names = first && !number(code) && !number(luminance);
        first = false;
        if (!names) points.push_back(read_row(line, code, luminance, points));
    }
    if (points.size() < 2) fail(std::max(line, 1), "the text ends here, expected two rows or more");
    return points;
}

TableTransfer read_table(std::string_view csv) {
    std::vector<TablePoint> points = read_rows(csv);
    const TablePoint black = points.front(), white = points.back();
    if (!(white.y > black.y)) {
        throw std::invalid_argument("the luminances of all rows are " + number_text(white.y) + ", expected a rise");
    }
    // To the quotients of differences, 1 exactly for the last.
    for (TablePoint& p : points) p = {(p.x - black.x) / (white.x - black.x), (p.y - black.y) / (white.y - black.y)};
    TableTransfer transfer{std::move(points)};
    check_points(transfer, "the table");
    return transfer;
}

}  // namespace

double encode(const TableTransfer& transfer, double linear) noexcept {
    return odd(linear, [&](double y) noexcept {
        const auto first = transfer.points.begin();
        // The first point at or above y, but one that has another before it, and the last where there is none.
        const auto found = std::lower_bound(first + 1, transfer.points.end() - 1, y,
                                            [](const TablePoint& point, double wanted) { return point.y < wanted; });
        if (y <= 0.0) return 0.0;
        return along((found - 1)->y, found->y, (found - 1)->x, found->x, y);
    });
}

double decode(const TableTransfer& transfer, double encoded) noexcept {
    return odd(encoded, [&](double x) noexcept {
        const auto found = std::lower_bound(transfer.points.begin() + 1, transfer.points.end() - 1, x,
                                            [](const TablePoint& point, double wanted) { return point.x < wanted; });
        return along((found - 1)->x, found->x, (found - 1)->y, found->y, x);
    });
}

void check_points(const TableTransfer& transfer, std::string_view what) {
    const std::vector<TablePoint>& points = transfer.points;
    const std::string label(what);
    check_range(static_cast<int>(std::min<std::size_t>(points.size(), std::size_t{1} << 30)), {2.0, kMostTablePoints},
                label + ": number of points");
    const auto expect = [&](std::size_t i, bool good, const std::string& expected) {
        if (good) return;
        throw std::invalid_argument(label + ": point " + std::to_string(i + 1) + " is " + number_text(points[i].x) +
                                    '=' + number_text(points[i].y) + ", expected " + expected);
    };
    const std::size_t last = points.size() - 1;
    expect(0, points[0] == TablePoint{0.0, 0.0}, "0=0");
    for (std::size_t i = 1; i <= last; ++i) {
        const TablePoint before = points[i - 1];
        expect(i, points[i].x > before.x, "a code above " + number_text(before.x));
        expect(i, points[i].y >= before.y, "light of " + number_text(before.y) + " or more");
    }
    expect(last, points[last] == TablePoint{1.0, 1.0}, "1=1 at the end");
    expect(last, points[last - 1].y < 1.0, "less light before it: the last piece must rise");
}

TableTransfer parse_table_transfer(std::string_view name, std::string_view csv) {
    try {
        return read_table(csv);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument("transfer table " + std::string(name) + ": " + error.what());
    }
}

TableTransfer read_table_transfer(const std::filesystem::path& path) {
    const std::string text = read_text_file(path);
    try {
        return read_table(text);
    } catch (const std::invalid_argument& error) {
        throw IoError(path, error.what());
    }
}

}  // namespace emulsion
