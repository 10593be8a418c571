#include "spectrum/named_spectra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <utility>

#include "core/units.h"
#include "spectrum/data_table.h"

namespace emulsion {

namespace {

constexpr std::string_view kIlluminants = "illuminants_5nm";
constexpr std::string_view kWideIlluminants = "illuminants_a_d_300_830_5nm";

/// Where a named spectrum is found.
struct Source {
    std::string_view table;
    std::string column;  // or row, of a glass
};

// pbrt-v4's glasses, whose data are those of these rows of data/glasses.csv.
constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kPbrtGlasses = {{
    {"BK7", "N_BK7"},
    {"BAF10", "N_BAF10"},
    {"FK51A", "N_FK51A"},
    {"LASF9", "LASFN9"},
    {"F5", "SF5"},
    {"F10", "SF10"},
    {"F11", "SF11"},
}};

// pbrt-v4's names other than those of glasses, metals and standard illuminants; the sensors have _r, _g and _b added.
constexpr std::array<std::string_view, 7> kPbrtMetals = {"Ag", "Al", "Au", "Cu", "CuZn", "MgO", "TiO2"};
constexpr std::array<std::string_view, 17> kPbrtSensors = {
    "canon_eos_100d",     "canon_eos_1dx_mkii", "canon_eos_200d",    "canon_eos_200d_mkii", "canon_eos_5d",
    "canon_eos_5d_mkii",  "canon_eos_5d_mkiii", "canon_eos_5d_mkiv", "canon_eos_5ds",       "canon_eos_m",
    "hasselblad_l1d_20c", "nikon_d810",         "nikon_d850",        "sony_ilce_6400",      "sony_ilce_7m3",
    "sony_ilce_7rm3",     "sony_ilce_9"};

void add_illuminants(std::map<std::string, Source, std::less<>>& sources) {
    for (const std::string_view table : {kIlluminants, kWideIlluminants}) {
        for (const std::string& column : data_table(table).column_names) {
            // The wide table comes last, and replaces the narrow one.
            if (column != "wavelength") sources["stdillum-" + column] = {table, column};
        }
    }
    for (int i = 1; i <= 12; ++i) {
        const std::string number = std::to_string(i);
        sources["stdillum-F" + number] = {kIlluminants, "FL" + number};
    }
}

void add_metals(std::map<std::string, Source, std::less<>>& sources) {
    for (const std::string_view table : {std::string_view("conductors_nk"), std::string_view("conductor_brass_nk")}) {
        for (const std::string& column : data_table(table).column_names) {
            const std::size_t underscore = column.find('_');
            if (underscore == std::string::npos) continue;
            const std::string suffix = column.substr(underscore) == "_n" ? "-eta" : "-k";
            sources["metal-" + column.substr(0, underscore) + suffix] = {table, column};
        }
    }
}

void add_glasses(std::map<std::string, Source, std::less<>>& sources) {
    constexpr std::string_view kTable = "glasses";
    for (const std::string& glass : data_table(kTable).row_names) sources["glass-" + glass] = {kTable, glass};
    for (const auto& [name, row] : kPbrtGlasses) sources["glass-" + std::string(name)] = {kTable, std::string(row)};
}

const std::map<std::string, Source, std::less<>>& sources() {
    static const std::map<std::string, Source, std::less<>> all = [] {
        std::map<std::string, Source, std::less<>> made;
        add_illuminants(made);
        add_metals(made);
        add_glasses(made);
        return made;
    }();
    return all;
}

// n^2 = 1 + sum B_j L^2 / (L^2 - C_j), with L in micrometres.
PiecewiseLinearSpectrum sellmeier_index(const std::string& glass) {
    const DataTable& table = data_table("glasses");
    const std::size_t row = table.row(glass);
    PiecewiseLinearSpectrum index;
    for (int lambda_nm = kMinWavelength_nm; lambda_nm <= kMaxWavelength_nm; ++lambda_nm) {
        const double squared_um2 = 1e-6 * lambda_nm * lambda_nm;
        double n_squared = 1.0;
        for (const auto& [b, c] : {std::pair{"B1", "C1"}, std::pair{"B2", "C2"}, std::pair{"B3", "C3"}}) {
            n_squared += table.column(b)[row] * squared_um2 / (squared_um2 - table.column(c)[row]);
        }
        index.lambda_nm.push_back(lambda_nm);
        index.value.push_back(std::sqrt(n_squared));
    }
    return index;
}

// Takes `prefix` off the front of `name`.
bool consume(std::string_view& name, std::string_view prefix) noexcept {
    if (!name.starts_with(prefix)) return false;
    name.remove_prefix(prefix.size());
    return true;
}

template <std::size_t N>
bool contains(const std::array<std::string_view, N>& names, std::string_view name) noexcept {
    return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

std::optional<Spectrum> named_spectrum(std::string_view name) {
    const auto found = sources().find(name);
    if (found == sources().end()) return std::nullopt;
    const Source& source = found->second;
    if (source.table == "glasses") return sellmeier_index(source.column);
    return tabulated_spectrum(source.table, source.column);
}

std::vector<std::string> named_spectrum_names() {
    std::vector<std::string> names;
    for (const auto& [name, source] : sources()) names.push_back(name);
    return names;
}

bool is_known_to_pbrt(std::string_view name) noexcept {
    if (name == "illum-acesD60") return true;
    if (consume(name, "glass-")) {
        return std::any_of(kPbrtGlasses.begin(), kPbrtGlasses.end(),
                           [name](const auto& glass) { return glass.first == name; });
    }
    if (consume(name, "stdillum-")) {
        constexpr std::array<std::string_view, 15> kNames = {"A",  "D50", "D65", "F1", "F2",  "F3",  "F4", "F5",
                                                             "F6", "F7",  "F8",  "F9", "F10", "F11", "F12"};
        return contains(kNames, name);
    }
    if (consume(name, "metal-")) {
        const std::size_t dash = name.find('-');
        if (dash == std::string_view::npos) return false;
        const std::string_view part = name.substr(dash);
        return (part == "-eta" || part == "-k") && contains(kPbrtMetals, name.substr(0, dash));
    }
    if (name.ends_with("_r") || name.ends_with("_g") || name.ends_with("_b")) {
        return contains(kPbrtSensors, name.substr(0, name.size() - 2));
    }
    return false;
}

}  // namespace emulsion
