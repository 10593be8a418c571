#include "spectrum/opponent.h"

#include "spectrum/color_context.h"

namespace emulsion {

Opponent opponent_from_rgb(const RGBd& linear) noexcept {
    const auto [r, g, b] = linear;
    return {r + g + b, r + g - b, r - g};
}

RGBd rgb_from_opponent(const Opponent& opponent) noexcept {
    const double red_and_green = 0.5 * (opponent.white_black + opponent.yellow_blue);
    return {0.5 * (red_and_green + opponent.red_green), 0.5 * (red_and_green - opponent.red_green),
            0.5 * (opponent.white_black - opponent.yellow_blue)};
}

ColorValues from_xyz(const OpponentSystem& /*system*/, const XYZd& xyz, const ColorContext& context) noexcept {
    const Opponent opponent = opponent_from_rgb(context.linear_from_xyz(xyz));
    return {{opponent.white_black, opponent.yellow_blue, opponent.red_green}};
}

XYZd to_xyz(const OpponentSystem& /*system*/, const ColorValues& color, const ColorContext& context) noexcept {
    return context.xyz_from_linear(rgb_from_opponent({color.value[0], color.value[1], color.value[2]}));
}

}  // namespace emulsion
