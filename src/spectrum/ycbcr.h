#pragma once
// Y'CbCr with non-constant luminance, of encoded RGB. For luma see spectrum/luma.h. Values are real numbers, not
// rounded to codes:
// full range: Y' in [0, 1], Cb and Cr in [0, 1] with greys at 0.5;
// narrow range: on the scale of 8-bit codes, Y' in [16, 235], Cb and Cr in [16, 240] with greys at 128. An n-bit code
// is the value times 2^(n - 8), rounded.

#include <array>
#include <concepts>
#include <string_view>

#include "core/color.h"
#include "spectrum/color_context.h"
#include "spectrum/color_values.h"
#include "spectrum/luma.h"

namespace emulsion {

struct Ycbcr {
    double luma = 0.0;  ///< Y'
    double cb = 0.0, cr = 0.0;
    bool operator==(const Ycbcr&) const = default;
};

/// The scale of the numbers: component = scale * (Y', or Cb and Cr in [-0.5, 0.5]) + offset.
struct YcbcrRange {
    double luma_scale = 1.0, luma_offset = 0.0;
    double chroma_scale = 1.0, chroma_offset = 0.5;
    bool operator==(const YcbcrRange&) const = default;
};
inline constexpr YcbcrRange kFullRange = {};
inline constexpr YcbcrRange kNarrowRange = {219.0, 16.0, 224.0, 128.0};  ///< ITU-R BT.709-6, for 8 bits

/// Cb = (B' - Y') / (2 (1 - kb)), Cr = (R' - Y') / (2 (1 - kr)), in [-0.5, 0.5] before the range's scale, for every
/// RGB. The divisors are derived from the weights: 1.772 and 1.402 (BT.601), 1.8556 and 1.5748 (BT.709), 1.8814
/// and 1.4746 (BT.2020). Source: ITU-R BT.601-7, 2.5; BT.709-6, 3.2 to 3.5; BT.2020-2, tables 4 and 5, "Y'CbCr" (not
/// Y'cCbcCrc).
[[nodiscard]] Ycbcr ycbcr_from_rgb(const LumaWeights& weights, const YcbcrRange& range, const RGBd& encoded) noexcept;
[[nodiscard]] RGBd rgb_from_ycbcr(const LumaWeights& weights, const YcbcrRange& range, const Ycbcr& ycbcr) noexcept;

// Primaries and transfer function are those of the context, as the three standards share neither: for the signal of
// BT.709 choose Rec709 and bt709 there.

inline constexpr std::array kFullYcbcrComponents = {ColorComponent{"Y'", 0.0, 1.0, "", "luma"},
                                                    ColorComponent{"Cb", 0.0, 1.0, "", "yellow to blue, grey 0.5"},
                                                    ColorComponent{"Cr", 0.0, 1.0, "", "cyan to red, grey 0.5"}};
inline constexpr std::array kNarrowYcbcrComponents = {
    ColorComponent{"Y'", 16.0, 235.0, "8-bit codes", "luma"},
    ColorComponent{"Cb", 16.0, 240.0, "8-bit codes", "yellow to blue, grey 128"},
    ColorComponent{"Cr", 16.0, 240.0, "8-bit codes", "cyan to red, grey 128"}};

struct YcbcrBt601System {
    static constexpr std::string_view kName = "ycbcr-bt601";
    static constexpr std::string_view kHelp = "Y'CbCr with the weights of BT.601 and JPEG, full range";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = kFullYcbcrComponents;
    static constexpr LumaWeights kWeights = kBt601Luma;
    static constexpr YcbcrRange kRange = kFullRange;
    bool operator==(const YcbcrBt601System&) const = default;
};

struct YcbcrBt601NarrowSystem {
    static constexpr std::string_view kName = "ycbcr-bt601-narrow";
    static constexpr std::string_view kHelp = "Y'CbCr with the weights of BT.601, narrow range";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = kNarrowYcbcrComponents;
    static constexpr LumaWeights kWeights = kBt601Luma;
    static constexpr YcbcrRange kRange = kNarrowRange;
    bool operator==(const YcbcrBt601NarrowSystem&) const = default;
};

struct YcbcrBt709System {
    static constexpr std::string_view kName = "ycbcr-bt709";
    static constexpr std::string_view kHelp = "Y'CbCr with the weights of BT.709, full range";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = kFullYcbcrComponents;
    static constexpr LumaWeights kWeights = kBt709Luma;
    static constexpr YcbcrRange kRange = kFullRange;
    bool operator==(const YcbcrBt709System&) const = default;
};

struct YcbcrBt709NarrowSystem {
    static constexpr std::string_view kName = "ycbcr-bt709-narrow";
    static constexpr std::string_view kHelp = "Y'CbCr with the weights of BT.709, narrow range";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = kNarrowYcbcrComponents;
    static constexpr LumaWeights kWeights = kBt709Luma;
    static constexpr YcbcrRange kRange = kNarrowRange;
    bool operator==(const YcbcrBt709NarrowSystem&) const = default;
};

struct YcbcrBt2020System {
    static constexpr std::string_view kName = "ycbcr-bt2020";
    static constexpr std::string_view kHelp = "Y'CbCr with the weights of BT.2020, full range";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = kFullYcbcrComponents;
    static constexpr LumaWeights kWeights = kBt2020Luma;
    static constexpr YcbcrRange kRange = kFullRange;
    bool operator==(const YcbcrBt2020System&) const = default;
};

struct YcbcrBt2020NarrowSystem {
    static constexpr std::string_view kName = "ycbcr-bt2020-narrow";
    static constexpr std::string_view kHelp = "Y'CbCr with the weights of BT.2020, narrow range";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = kNarrowYcbcrComponents;
    static constexpr LumaWeights kWeights = kBt2020Luma;
    static constexpr YcbcrRange kRange = kNarrowRange;
    bool operator==(const YcbcrBt2020NarrowSystem&) const = default;
};

template <class T>
concept YcbcrSystem = requires {
    { T::kWeights } -> std::convertible_to<LumaWeights>;
    { T::kRange } -> std::convertible_to<YcbcrRange>;
};

template <YcbcrSystem System>
[[nodiscard]] ColorValues from_xyz(const System& /*system*/, const XYZd& xyz, const ColorContext& context) noexcept {
    const Ycbcr ycbcr = ycbcr_from_rgb(System::kWeights, System::kRange, context.encoded_from_xyz(xyz));
    return {{ycbcr.luma, ycbcr.cb, ycbcr.cr}};
}
template <YcbcrSystem System>
[[nodiscard]] XYZd to_xyz(const System& /*system*/, const ColorValues& color, const ColorContext& context) noexcept {
    const Ycbcr ycbcr = {color.value[0], color.value[1], color.value[2]};
    return context.xyz_from_encoded(rgb_from_ycbcr(System::kWeights, System::kRange, ycbcr));
}

}  // namespace emulsion
