#pragma once
// Luma: the weighted sum of encoded R'G'B' that television calls Y'. It is no luminance: that is the sum of linear RGB,
// and its weights are those of the display's primaries.

#include "core/color.h"

namespace emulsion {

/// Y' = kr R' + (1 - kr - kb) G' + kb B'. All three weights are > 0.
struct LumaWeights {
    double kr = 0.0, kb = 0.0;
    [[nodiscard]] constexpr double kg() const noexcept { return 1.0 - kr - kb; }
    bool operator==(const LumaWeights&) const = default;
};

inline constexpr LumaWeights kBt601Luma = {0.299, 0.114};     ///< ITU-R BT.601-7; PAL, NTSC, JPEG
inline constexpr LumaWeights kBt709Luma = {0.2126, 0.0722};   ///< ITU-R BT.709-6
inline constexpr LumaWeights kBt2020Luma = {0.2627, 0.0593};  ///< ITU-R BT.2020-2, BT.2100-2

/// What all of these systems are made of: luma and the two colour differences.
struct LumaDifferences {
    double luma = 0.0;        ///< Y'
    double blue_minus = 0.0;  ///< B' - Y'
    double red_minus = 0.0;   ///< R' - Y'
    bool operator==(const LumaDifferences&) const = default;
};

[[nodiscard]] constexpr LumaDifferences luma_differences_of(const LumaWeights& weights, const RGBd& encoded) noexcept {
    const double luma = weights.kr * encoded.r + weights.kg() * encoded.g + weights.kb * encoded.b;
    return {luma, encoded.b - luma, encoded.r - luma};
}
/// The inverse.
[[nodiscard]] constexpr RGBd rgb_of(const LumaWeights& weights, const LumaDifferences& of) noexcept {
    // The weighted differences sum to 0, which gives G' - Y'.
    const double green_minus = -(weights.kr * of.red_minus + weights.kb * of.blue_minus) / weights.kg();
    return {of.luma + of.red_minus, of.luma + green_minus, of.luma + of.blue_minus};
}

}  // namespace emulsion
