#pragma once
// A display's own curve, as it was measured. For "linear" and "encoded" see spectrum/transfer_function.h.

#include <filesystem>
#include <string_view>
#include <vector>

#include "core/table_point.h"

namespace emulsion {

/// decode(v) runs straight between points x = code, y = light, both relative to the first and the last: they begin with
/// 0=0 and end with 1=1. encode is its exact inverse; of codes that show the same light it gives the least. Above 1 the
/// last piece goes on. The more points the better: even in 17 of a power of 2.2, straight pieces are off by 0.0013.
struct TableTransfer {
    static constexpr std::string_view kName = "table";
    static constexpr std::string_view kHelp = "points code=light as measured, from 0=0 to 1=1";
    std::vector<TablePoint> points = {{0.0, 0.0}, {1.0, 1.0}};
    bool operator==(const TableTransfer&) const = default;
};

inline constexpr int kMostTablePoints = 1024;

/// \param transfer with points as check_points() asks for
[[nodiscard]] double encode(const TableTransfer& transfer, double linear) noexcept;
[[nodiscard]] double decode(const TableTransfer& transfer, double encoded) noexcept;

/// \throws std::invalid_argument naming `what`, the point, its value and what was expected, unless there are 2 to
/// kMostTablePoints points, the first is 0=0, the last 1=1, codes rise, light doesn't fall, and rises to the last.
void check_points(const TableTransfer& transfer, std::string_view what);

/// Reads comma-separated text: lines that are empty or start with '#' are left out, and so is a first line of names.
/// Then a row a line: the code (or signal) sent, and the luminance measured, each on any scale. The light of the first
/// row, black, is taken off.
/// \throws std::invalid_argument naming `name`, the line (from 1), the value and what was expected.
[[nodiscard]] TableTransfer parse_table_transfer(std::string_view name, std::string_view csv);

/// The same of a file. \throws IoError naming the file, the line, the value and what was expected.
[[nodiscard]] TableTransfer read_table_transfer(const std::filesystem::path& path);

}  // namespace emulsion
