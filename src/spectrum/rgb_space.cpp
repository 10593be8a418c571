#include "spectrum/rgb_space.h"

#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include <fmt/core.h>

#include "core/name_key.h"
#include "spectrum/data_table.h"

namespace emulsion {

namespace {

std::vector<RgbSpace> tabulated_spaces() {
    const DataTable& table = data_table("rgb_colourspaces");
    std::vector<RgbSpace> spaces(table.row_count());
    for (std::size_t i = 0; i < spaces.size(); ++i) {
        const auto point = [&](const char* x, const char* y) {
            return Chromaticity{table.column(x)[i], table.column(y)[i]};
        };
        spaces[i] = {table.row_names[i], point("xr", "yr"), point("xg", "yg"), point("xb", "yb"), point("xw", "yw")};
    }
    return spaces;
}

/// What some spaces are called, too: without the name of their primaries, and as the ITU writes them.
constexpr std::array kOtherNames = {std::pair<std::string_view, std::string_view>{"Rec.709", "Rec709"},
                                    std::pair<std::string_view, std::string_view>{"Rec.2020", "Rec2020"},
                                    std::pair<std::string_view, std::string_view>{"ACEScg", "ACEScg_AP1"},
                                    std::pair<std::string_view, std::string_view>{"ACES2065-1", "ACES2065_1_AP0"},
                                    std::pair<std::string_view, std::string_view>{"ProPhoto", "ROMM_ProPhoto"}};

/// The key of a name in the table.
std::string table_key(std::string_view name) {
    std::string key = name_key(name);
    for (const auto& [other_name, name_in_table] : kOtherNames) {
        if (key == name_key(other_name)) return name_key(name_in_table);
    }
    return key;
}

}  // namespace

const RgbSpace& rgb_space(std::string_view name) {
    static const std::vector<RgbSpace> spaces = tabulated_spaces();
    const std::string wanted = table_key(name);
    for (const RgbSpace& space : spaces) {
        if (name_key(space.name) == wanted) return space;
    }
    throw std::invalid_argument(fmt::format("RGB space \"{}\" is unknown: expected one of {}", name,
                                            listed(data_table("rgb_colourspaces").row_names)));
}

namespace {

/// \throws std::invalid_argument naming the primaries if they span no triangle.
Matrix3 inverse_of(const Matrix3& matrix, const std::array<Chromaticity, 3>& primary) {
    try {
        return inverse(matrix);
    } catch (const std::invalid_argument&) {
        throw std::invalid_argument(fmt::format(
            "primaries ({:.6g}, {:.6g}), ({:.6g}, {:.6g}) and ({:.6g}, {:.6g}) lie on one line, expected a triangle",
            primary[0].x, primary[0].y, primary[1].x, primary[1].y, primary[2].x, primary[2].y));
    }
}

}  // namespace

Matrix3 xyz_from_rgb(const RgbSpace& space) {
    // Columns x, y, z of the primaries; y may be 0 or negative for imaginary ones, so not scaled to Y = 1.
    const std::array<Chromaticity, 3> primary = {space.red, space.green, space.blue};
    Matrix3 matrix;
    for (std::size_t j = 0; j < 3; ++j) {
        matrix.m[0][j] = primary[j].x;
        matrix.m[1][j] = primary[j].y;
        matrix.m[2][j] = 1.0 - primary[j].x - primary[j].y;
    }

    // Amounts of the primaries that add up to the white.
    const XYZd white = xyz_of(space.white);
    const std::array<double, 3> amount = inverse_of(matrix, primary) * std::array<double, 3>{white.x, white.y, white.z};
    for (auto& row : matrix.m) {
        for (std::size_t j = 0; j < 3; ++j) row[j] *= amount[j];
    }
    return matrix;
}

Matrix3 rgb_from_xyz(const RgbSpace& space) { return inverse(xyz_from_rgb(space)); }

Matrix3 rgb_from_rgb(const RgbSpace& from, const RgbSpace& to) { return rgb_from_xyz(to) * xyz_from_rgb(from); }

Matrix3 rgb_from_rgb(const RgbSpace& from, const RgbSpace& to, const Matrix3& adaptation) {
    return rgb_from_xyz(to) * adaptation * xyz_from_rgb(from);
}

}  // namespace emulsion
