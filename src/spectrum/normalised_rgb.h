#pragma once
// "Normalised" RGB: the linear RGB of a matrix in older books on rendering, in which RGB (1, 1, 1) is XYZ (1, 1, 1). It
// is close to EBU primaries with the white of illuminant E (0.5141 0.3239 0.1620 / ...), but no display has it: kept as
// a curiosity, to read old data.

#include <array>
#include <string_view>

#include "core/color.h"
#include "core/matrix3.h"
#include "spectrum/color_values.h"

namespace emulsion {

/// As printed, to four decimals: the only RGB matrix here that isn't derived from primaries and white.
inline constexpr Matrix3 kXyzFromNormalisedRgb{
    {{{0.5149, 0.3244, 0.1607}, {0.2654, 0.6704, 0.0642}, {0.0248, 0.1248, 0.8504}}}};

/// For every XYZ, relative or absolute.
[[nodiscard]] RGBd normalised_rgb_from_xyz(const XYZd& xyz) noexcept;
[[nodiscard]] XYZd xyz_from_normalised_rgb(const RGBd& rgb) noexcept;

struct NormalisedRgbSystem {
    static constexpr std::string_view kName = "rgb-normalised";
    static constexpr std::string_view kHelp = "linear RGB of an old matrix, (1, 1, 1) is XYZ (1, 1, 1)";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = {ColorComponent{"R", 0.0, 0.8378, "", "red"},
                                               ColorComponent{"G", -0.00002104, 1.055, "", "green"},
                                               ColorComponent{"B", -0.01625, 1.118, "", "blue"}};
    bool operator==(const NormalisedRgbSystem&) const = default;
};
[[nodiscard]] ColorValues from_xyz(const NormalisedRgbSystem& system, const XYZd& xyz,
                                   const ColorContext& context) noexcept;
[[nodiscard]] XYZd to_xyz(const NormalisedRgbSystem& system, const ColorValues& color,
                          const ColorContext& context) noexcept;

}  // namespace emulsion
