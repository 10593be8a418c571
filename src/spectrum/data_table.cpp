#include "spectrum/data_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <mutex>
#include <stdexcept>

#include <fmt/core.h>

#include "spectrum/embedded_tables.h"

namespace emulsion {

namespace {

constexpr std::string_view kMicrometres = "wavelength_um";

std::size_t index_of(std::string_view what, std::string_view name, std::span<const std::string> names) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    throw std::invalid_argument(fmt::format("{} \"{}\" is unknown: expected one of {}", what, name, listed(names)));
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0;;) {
        const std::size_t end = text.find(separator, begin);
        parts.push_back(text.substr(begin, end == std::string_view::npos ? end : end - begin));
        if (end == std::string_view::npos) return parts;
        begin = end + 1;
    }
}

[[noreturn]] void fail(const DataTable& table, std::size_t line, const std::string& problem) {
    throw std::invalid_argument(fmt::format("table {}, line {}: {}", table.name, line, problem));
}

bool is_wavelength(std::string_view column_name) noexcept {
    return column_name == "wavelength" || column_name == kMicrometres;
}

double number(const DataTable& table, std::size_t line, std::string_view cell) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value)) {
        fail(table, line, fmt::format("\"{}\": expected a finite number", cell));
    }
    return value;
}

void append_row(DataTable& table, bool has_row_names, std::size_t line, std::string_view text) {
    const std::vector<std::string_view> cells = split(text, ',');
    const std::size_t first = has_row_names ? 1 : 0;
    if (cells.size() != table.columns.size() + first) {
        fail(table, line,
             fmt::format("{} cells: expected {}, as in the line of names", cells.size(), table.columns.size() + first));
    }
    if (has_row_names) table.row_names.emplace_back(cells.front());
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        std::vector<double>& column = table.columns[i];
        const double value = number(table, line, cells[i + first]);
        if (is_wavelength(table.column_names[i]) && !column.empty() && value <= column.back()) {
            fail(table, line, fmt::format("wavelength {}: expected more than in the line before", cells[i + first]));
        }
        column.push_back(value);
    }
}

}  // namespace

std::string listed(std::span<const std::string> names) {
    std::string list;
    for (const std::string& name : names) {
        if (!list.empty()) list += ", ";
        list += name;
    }
    return list;
}

const std::vector<double>& DataTable::column(std::string_view column_name) const {
    return columns[index_of(fmt::format("table {}: column", name), column_name, column_names)];
}

std::size_t DataTable::row(std::string_view row_name) const {
    return index_of(fmt::format("table {}: row", name), row_name, row_names);
}

DataTable parse_data_table(std::string_view name, std::string_view text) {
    DataTable table;
    table.name = name;
    if (!text.empty() && text.back() == '\n') text.remove_suffix(1);
    const std::vector<std::string_view> lines = split(text, '\n');
    if (lines.front().empty() || lines.front().front() != '#') {
        fail(table, 1, "expected a comment that starts with #");
    }
    table.comment = lines.front().substr(std::min(lines.front().find_first_not_of("# "), lines.front().size()));
    if (lines.size() < 3)
        fail(table, lines.size(), "the text ends here: expected a line of names and at least one row");

    for (const std::string_view column_name : split(lines[1], ',')) table.column_names.emplace_back(column_name);
    const bool has_row_names = table.column_names.front() == "name";
    if (has_row_names) table.column_names.erase(table.column_names.begin());
    table.columns.resize(table.column_names.size());
    for (std::size_t i = 2; i < lines.size(); ++i) append_row(table, has_row_names, i + 1, lines[i]);
    return table;
}

const DataTable& data_table(std::string_view name) {
    // Nodes of a map stay where they are, so references handed out remain good.
    static std::mutex mutex;
    static std::map<std::string, DataTable, std::less<>> parsed;
    const std::lock_guard lock(mutex);
    if (const auto found = parsed.find(name); found != parsed.end()) return found->second;

    std::vector<std::string> known;
    for (const EmbeddedTableFile& file : embedded_table_files()) {
        if (file.name == name) {
            return parsed.emplace(std::string(name), parse_data_table(file.name, file.text)).first->second;
        }
        known.emplace_back(file.name);
    }
    throw std::invalid_argument(fmt::format("table \"{}\" is unknown: expected one of {}", name, listed(known)));
}

std::vector<double> wavelengths_nm(const DataTable& table) {
    const auto um = std::find(table.column_names.begin(), table.column_names.end(), kMicrometres);
    if (um == table.column_names.end()) return table.column("wavelength");
    std::vector<double> wavelengths = table.column(kMicrometres);
    for (double& wavelength : wavelengths) wavelength *= 1000.0;
    return wavelengths;
}

PiecewiseLinearSpectrum tabulated_spectrum(std::string_view table_name, std::string_view column_name) {
    const DataTable& table = data_table(table_name);
    return {wavelengths_nm(table), table.column(column_name)};
}

}  // namespace emulsion
