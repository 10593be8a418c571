#pragma once
// Opponent colours: the textbook's sum and two differences, of linear RGB.

#include <array>
#include <string_view>

#include "core/color.h"
#include "spectrum/color_values.h"

namespace emulsion {

/// Black to white, blue to yellow, green to red. Without weights: the sum is no luminance, and white is not neutral in
/// the second (it has 1).
struct Opponent {
    double white_black = 0.0;  ///< R + G + B
    double yellow_blue = 0.0;  ///< R + G - B
    double red_green = 0.0;    ///< R - G
    bool operator==(const Opponent&) const = default;
};

/// For every RGB. No standard defines it; the idea is Hering's, Zur Lehre vom Lichtsinne (1878).
[[nodiscard]] Opponent opponent_from_rgb(const RGBd& linear) noexcept;
[[nodiscard]] RGBd rgb_from_opponent(const Opponent& opponent) noexcept;

struct OpponentSystem {
    static constexpr std::string_view kName = "opponent";
    static constexpr std::string_view kHelp = "sum and differences of linear RGB";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = {ColorComponent{"R+G+B", 0.0, 3.0, "", "black to white"},
                                               ColorComponent{"R+G-B", -1.0, 2.0, "", "blue to yellow"},
                                               ColorComponent{"R-G", -1.0, 1.0, "", "green to red"}};
    bool operator==(const OpponentSystem&) const = default;
};
[[nodiscard]] ColorValues from_xyz(const OpponentSystem& system, const XYZd& xyz, const ColorContext& context) noexcept;
[[nodiscard]] XYZd to_xyz(const OpponentSystem& system, const ColorValues& color, const ColorContext& context) noexcept;

}  // namespace emulsion
