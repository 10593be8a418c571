#include "spectrum/catalogue_names.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "spectrum/data_table.h"

namespace emulsion {

namespace {

constexpr std::string_view kDimensionless = "1";
constexpr std::string_view kRelativePower = "relative power";

// In chart order, row by row from the top left.
constexpr std::array<std::string_view, 24> kColorCheckerPatches = {
    "dark-skin", "light-skin",    "blue-sky",     "foliage",   "blue-flower",  "bluish-green",
    "orange",    "purplish-blue", "moderate-red", "purple",    "yellow-green", "orange-yellow",
    "blue",      "green",         "red",          "yellow",    "magenta",      "cyan",
    "white",     "neutral-8",     "neutral-6.5",  "neutral-5", "neutral-3.5",  "black"};

// pbrt-v4's names of glasses, beside the catalogue's. Its F5, F10 and F11 are SF5, SF10 and SF11.
constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kPbrtGlasses = {{
    {"N_BK7", "glass-BK7"},
    {"N_BAF10", "glass-BAF10"},
    {"N_FK51A", "glass-FK51A"},
    {"LASFN9", "glass-LASF9"},
    {"SF5", "glass-F5"},
    {"SF10", "glass-F10"},
    {"SF11", "glass-F11"},
}};

/// How the columns of one table become entries.
struct NamedTable {
    std::string_view table;
    std::string_view prefix;
    NamedSpectrumInfo (*entry)(std::string_view prefix, const std::string& column, std::size_t index);
};

std::string joined(std::string_view a, std::string_view b) { return std::string(a) + std::string(b); }

NamedSpectrumInfo entry_of(std::string name, std::string_view group, std::string_view unit) {
    NamedSpectrumInfo entry;
    entry.name = std::move(name);
    entry.group = group;
    entry.unit = unit;
    return entry;
}

NamedSpectrumInfo illuminant(std::string_view prefix, const std::string& column, std::size_t /*index*/) {
    NamedSpectrumInfo entry = entry_of(joined(prefix, column), kIlluminantGroup, kRelativePower);
    entry.aliases.push_back("stdillum-" + column);
    if (column.starts_with("FL") && column.find('_') == std::string::npos) {
        const std::string old_name = "F" + column.substr(2);
        entry.aliases.push_back(old_name);
        entry.aliases.push_back("stdillum-" + old_name);
    }
    return entry;
}

NamedSpectrumInfo reflectance(std::string_view prefix, const std::string& column, std::size_t /*index*/) {
    return entry_of(joined(prefix, column), kReflectanceGroup, kDimensionless);
}

NamedSpectrumInfo colorchecker(std::string_view prefix, const std::string& column, std::size_t index) {
    NamedSpectrumInfo entry =
        entry_of(joined(prefix, kColorCheckerPatches.at(index)), kReflectanceGroup, kDimensionless);
    if (index >= 18) entry.aliases.push_back(joined(prefix, column));  // "white_9_5_05_d": as the table has it
    return entry;
}

NamedSpectrumInfo cornell(std::string_view prefix, const std::string& column, std::size_t index) {
    if (column != "light_emission") return reflectance(prefix, column, index);
    NamedSpectrumInfo entry = entry_of(joined(prefix, "light"), kEmissionGroup, kRelativePower);
    entry.aliases.push_back(joined(prefix, column));
    return entry;
}

NamedSpectrumInfo metal(std::string_view prefix, const std::string& column, std::size_t /*index*/) {
    const bool is_index = column.ends_with("_n");
    const std::string symbol = column.substr(0, column.find('_'));
    return entry_of(joined(prefix, symbol) + (is_index ? "-eta" : "-k"), is_index ? kIndexGroup : kExtinctionGroup,
                    kDimensionless);
}

NamedSpectrumInfo efficiency(std::string_view prefix, const std::string& column, std::size_t /*index*/) {
    NamedSpectrumInfo entry = entry_of(joined(prefix, column), kEfficiencyGroup, kDimensionless);
    if (column == "V_prime") entry.aliases.emplace_back("V'");
    return entry;
}

NamedSpectrumInfo matching(std::string_view prefix, const std::string& column, std::size_t /*index*/) {
    return entry_of(joined(prefix, column), kMatchingGroup, kDimensionless);
}

NamedSpectrumInfo daylight(std::string_view prefix, const std::string& column, std::size_t /*index*/) {
    return entry_of(joined(prefix, column), kDaylightGroup, kRelativePower);
}

NamedSpectrumInfo glass(std::string_view prefix, const std::string& row, std::size_t /*index*/) {
    NamedSpectrumInfo entry = entry_of(joined(prefix, row == "F5" ? "schott-F5" : row), kIndexGroup, kDimensionless);
    for (const auto& [ours, pbrts] : kPbrtGlasses) {
        if (ours == row) entry.aliases.emplace_back(pbrts);
    }
    return entry;
}

// The wide table of illuminants goes before the narrow one, which has some of the same names.
constexpr std::array<NamedTable, 17> kTables = {{
    {"illuminants_a_d_300_830_5nm", "", illuminant},
    {"illuminants_5nm", "", illuminant},
    {"cornell_box", "cornell-", cornell},
    {"colorchecker_reflectance", "colorchecker-", colorchecker},
    {"munsell_cqs_saturated_5nm", "", reflectance},
    {"munsell_cri_tcs_5nm", "", reflectance},
    {"reflectances_ampas24_5nm", "ampas-", reflectance},
    {"conductors_nk", "metal-", metal},
    {"conductor_brass_nk", "metal-", metal},
    {"conductors_johnson_christy_nk", "johnson-christy-", metal},
    {"cie_1924_photopic_1nm", "", efficiency},
    {"cie_1951_scotopic_1nm", "", efficiency},
    {"cie_1931_2deg_xyz_1nm", "cie_1931_2deg-", matching},
    {"cie_1964_10deg_xyz_1nm", "cie_1964_10deg-", matching},
    {"cie_2015_2deg_xyz_1nm", "cie_2015_2deg-", matching},
    {"stockman_sharpe_2deg_lms_1nm", "stockman_sharpe_2deg-", matching},
    {"cie_daylight_basis_5nm", "", daylight},
}};

}  // namespace

std::vector<NamedSpectrumInfo> named_columns() {
    std::vector<NamedSpectrumInfo> entries;
    const auto add = [&](const NamedTable& from, const std::vector<std::string>& columns, std::size_t first) {
        for (std::size_t i = first; i < columns.size(); ++i) {
            entries.push_back(from.entry(from.prefix, columns[i], i - first));
            entries.back().table = from.table;
            entries.back().column = columns[i];
        }
    };
    for (const NamedTable& from : kTables) add(from, data_table(from.table).column_names, 1);
    add({kGlassTable, "glass-", glass}, data_table(kGlassTable).row_names, 0);
    return entries;
}

}  // namespace emulsion
