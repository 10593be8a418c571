#include "cli/number_rows.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/messages.h"
#include "core/error.h"
#include "core/text_file.h"

namespace emulsion::cli {

namespace {

constexpr std::string_view kStandardInput = "standard input";

std::vector<std::string_view> cells_of(std::string_view line) {
    // A comma or semicolon ends a cell, which may be empty; blanks only part what they lie between.
    std::vector<std::string_view> cells;
    constexpr std::string_view kBlanks = " \t\r", kAll = " \t\r,;";
    std::size_t at = line.find_first_not_of(kBlanks);
    while (at != std::string_view::npos) {
        const std::size_t end = std::min(line.find_first_of(kAll, at), line.size());
        cells.push_back(line.substr(at, end - at));
        at = line.find_first_not_of(kBlanks, end);
        if (at == std::string_view::npos || (line[at] != ',' && line[at] != ';')) continue;
        at = line.find_first_not_of(kBlanks, at + 1);
        if (at == std::string_view::npos) cells.emplace_back();  // the line ends with its separator
    }
    return cells;
}

std::optional<double> number_of(std::string_view cell) {
    if (cell.size() > 1 && cell[0] == '+' && cell[1] != '-') cell.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

/// Whether a first row names columns. What looks like a number, be it malformed, not finite or in quotes, is no name.
bool are_names(std::span<const std::string_view> cells) {
    return std::all_of(cells.begin(), cells.end(), [](std::string_view cell) {
        constexpr std::string_view kQuotes = "\"'", kNumberStarts = "+-.0123456789";
        cell.remove_prefix(std::min(cell.find_first_not_of(kQuotes), cell.size()));
        cell = cell.substr(0, cell.find_last_not_of(kQuotes) + 1);
        if (cell.empty() || kNumberStarts.find(cell.front()) != std::string_view::npos) return false;
        double ignored = 0.0;  // "nan" and "inf" are numbers, too, but "nanometres" is a name
        return std::from_chars(cell.data(), cell.data() + cell.size(), ignored).ptr != cell.data() + cell.size();
    });
}

std::string read_standard_input() {
    std::string text;
    char buffer[1 << 16];
    errno = 0;
    for (std::size_t size = 0; (size = std::fread(buffer, 1, sizeof buffer, stdin)) > 0;) text.append(buffer, size);
    if (std::ferror(stdin) != 0) throw IoError(std::string(kStandardInput), "reading failed: " + errno_text(errno));
    return text;
}

}  // namespace

NumberRows parse_number_rows(std::string_view text, std::string_view source,
                             std::span<const std::string_view> columns) {
    NumberRows rows{columns.size(), {}, ' '};
    std::size_t line_number = 0, row_number = 0;
    const auto fail = [&](const std::string& problem) {
        throw IoError(std::string(source), fmt::format("row {} (line {}): {}", row_number, line_number, problem));
    };
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";  // spreadsheets begin their CSV with it
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());

    bool is_first = true;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        ++line_number;
        const std::vector<std::string_view> cells = cells_of(line);
        if (cells.empty() || cells.front().starts_with('#')) continue;

        const bool may_be_names = std::exchange(is_first, false);
        if (may_be_names && line.find(',') != std::string_view::npos) rows.separator = ',';
        const bool may_fit = columns.empty() || cells.size() == columns.size();
        if (may_be_names && may_fit && are_names(cells)) continue;
        ++row_number;
        if (rows.columns == 0) rows.columns = cells.size();
        if (cells.size() != rows.columns) {
            fail(fmt::format("found {} cell{}, expected {}{}{}", cells.size(), cells.size() == 1 ? "" : "s",
                             rows.columns, columns.empty() ? " as in the first row" : ": ", fmt::join(columns, " ")));
        }
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const std::optional<double> value = number_of(cells[i]);
            if (!value) {
                const std::string what = columns.empty() ? fmt::format("cell {}", i + 1) : std::string(columns[i]);
                fail(fmt::format("found \"{}\" for {}, expected a finite number", cells[i], what));
            }
            rows.values.push_back(*value);
        }
    }
    return rows;
}

NumberRows read_number_rows(const std::optional<std::filesystem::path>& file,
                            std::span<const std::string_view> columns) {
    if (file && *file != "-") return parse_number_rows(read_text_file(*file), file->string(), columns);
    return parse_number_rows(read_standard_input(), kStandardInput, columns);
}

std::string number_row_text(std::span<const double> row, char separator) {
    std::string text;
    for (const double value : row) {
        if (!text.empty()) text += separator;
        text += std::isnan(value) ? "nan" : fmt::format("{:.17g}", value);  // whatever the sign bit of NaN
    }
    return text + '\n';
}

void print_rows(const NumberRows& rows) {
    std::size_t lost = 0, first_lost = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto row = rows.row(i);
        print_output(number_row_text(row, rows.separator));
        if (std::all_of(row.begin(), row.end(), [](double value) { return std::isfinite(value); })) continue;
        if (lost++ == 0) first_lost = i;
    }
    if (lost == 0) return;
    print_warning(fmt::format("{} of {} rows came out with numbers that aren't finite, row {}{}", lost, rows.size(),
                              first_lost + 1, lost == 1 ? "" : " first"));
}

}  // namespace emulsion::cli
