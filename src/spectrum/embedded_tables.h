#pragma once
// The tables of data/, compiled into the library as text.

#include <span>
#include <string_view>

namespace emulsion {

struct EmbeddedTableFile {
    std::string_view name;  ///< the file's name without folder and ending: "cie_1931_2deg_xyz_1nm"
    std::string_view text;  ///< its whole content; data/README.md says what each holds
};

[[nodiscard]] std::span<const EmbeddedTableFile> embedded_table_files() noexcept;

}  // namespace emulsion
