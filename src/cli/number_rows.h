#pragma once
// Rows of numbers, as the `emulsion color` commands read and write them: one row a line, cells separated by commas,
// semicolons, blanks or tabs. Empty lines and lines that start with '#' are passed over; so is a first row of names:
// none of its cells looks like a number, not even like a malformed one ("nan", "50%", "\"1\"").

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace emulsion::cli {

struct NumberRows {
    std::size_t columns = 0;     ///< 0 only if there are no rows
    std::vector<double> values;  ///< row by row; all finite
    char separator = ' ';        ///< ',' if the first row has commas: rows are written as they were read

    [[nodiscard]] std::size_t size() const noexcept { return columns == 0 ? 0 : values.size() / columns; }
    [[nodiscard]] std::span<const double> row(std::size_t i) const noexcept {
        return std::span(values).subspan(i * columns, columns);
    }
};

/// `columns` are the names of the numbers that a row must have, for messages; none: any number, the same in all rows.
/// `source` says where the text is from.
/// \throws IoError naming source, row (and line), the cell found and what was expected.
[[nodiscard]] NumberRows parse_number_rows(std::string_view text, std::string_view source,
                                           std::span<const std::string_view> columns);

/// Reads a file, or standard input if there is none or it is "-".
/// \throws IoError as parse_number_rows does, and if the file can't be read.
[[nodiscard]] NumberRows read_number_rows(const std::optional<std::filesystem::path>& file,
                                          std::span<const std::string_view> columns);

/// "0.20000000000000001 1 2.5\n": 17 digits, which every double survives.
[[nodiscard]] std::string number_row_text(std::span<const double> row, char separator);

/// All rows, to standard output. Warns if numbers aren't finite, as colours outside a system's domain have it.
void print_rows(const NumberRows& rows);

}  // namespace emulsion::cli
