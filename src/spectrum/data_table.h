#pragma once
// The tables of data/ as numbers: named columns of doubles. data/README.md gives the quantity and unit of each.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spectrum/spectrum.h"

namespace emulsion {

/// One table. All columns have row_count() entries.
struct DataTable {
    std::string name;                          ///< "illuminants_5nm"
    std::string comment;                       ///< the first line, without "# ": quantity, unit, range, source
    std::vector<std::string> column_names;     ///< of the columns of numbers
    std::vector<std::vector<double>> columns;  ///< columns[i] belongs to column_names[i]; finite
    std::vector<std::string> row_names;        ///< the first column, if that holds names (headed "name"); else empty

    [[nodiscard]] std::size_t row_count() const noexcept { return columns.empty() ? 0 : columns.front().size(); }

    /// \throws std::invalid_argument for an unknown name, listing those that exist.
    [[nodiscard]] const std::vector<double>& column(std::string_view column_name) const;
    /// The row of this name, in a table whose first column holds names.
    /// \throws std::invalid_argument for an unknown name, listing those that exist.
    [[nodiscard]] std::size_t row(std::string_view row_name) const;
};

/// An embedded table, by the name of its file without ending; parsed on first use. May be called from many threads.
/// \throws std::invalid_argument for an unknown name, listing those that exist, and for a malformed table.
[[nodiscard]] const DataTable& data_table(std::string_view name);

/// Reads comma-separated text: a first line starting with '#', a line of column names, then rows. A column named
/// "wavelength" (in nm) or "wavelength_um" (in micrometres) must rise strictly.
/// \throws std::invalid_argument naming the table, the line (from 1), the value and what was expected.
[[nodiscard]] DataTable parse_data_table(std::string_view name, std::string_view text);

/// Wavelengths of a table in nm, be they tabulated in nm ("wavelength") or in micrometres ("wavelength_um").
/// \throws std::invalid_argument if it has neither column.
[[nodiscard]] std::vector<double> wavelengths_nm(const DataTable& table);

/// A column over the wavelengths of its table, in nm.
/// \throws std::invalid_argument for an unknown table or column, and for a table without wavelengths.
[[nodiscard]] PiecewiseLinearSpectrum tabulated_spectrum(std::string_view table_name, std::string_view column_name);

/// "a, b, c": for errors that say what exists.
[[nodiscard]] std::string listed(std::span<const std::string> names);

}  // namespace emulsion
