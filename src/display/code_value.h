#pragma once
// Code values: what a file or a display is sent.

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <string_view>
#include <variant>

#include "core/color.h"
#include "core/parameters.h"

namespace emulsion {

/// Codes of up to 16 bits.
using CodeRGB = BasicRGB<std::uint16_t>;

struct FullRange {
    static constexpr std::string_view kName = "full";
    static constexpr std::string_view kHelp = "code 0 is encoded 0, the largest code is encoded 1";
    bool operator==(const FullRange&) const = default;
};

/// Codes below and above are left to signals that go past black and white; nothing here makes any.
/// Source: ITU-R BT.2100-2, table 9; of BT.709 the same.
struct NarrowRange {
    static constexpr std::string_view kName = "narrow";
    static constexpr std::string_view kHelp = "16 to 235 of 8 bits, in that proportion of more; as video has it";
    bool operator==(const NarrowRange&) const = default;
};

/// All ranges; the first is the default.
using CodeRange = std::variant<FullRange, NarrowRange>;

inline constexpr ParameterRange kCodeBits = {1.0, 16.0};

/// The codes of encoded 0 and 1; those between are evenly spaced.
struct CodeScale {
    int black = 0, white = 255;
    [[nodiscard]] constexpr int steps() const noexcept { return white - black; }
    bool operator==(const CodeScale&) const = default;
};

/// \throws std::invalid_argument naming bits and their range: 1 to 16, 8 to 16 for the narrow range.
[[nodiscard]] CodeScale code_scale(int bits, const CodeRange& range);

/// A component for the quantizers: NaN as 0, others to the nearest value in [0, 1]. In the bits of the float, which are
/// ordered as positive floats are, since compilers take a comparison of floats for one that may trap, and then won't
/// make vectors of the loop.
[[nodiscard]] constexpr float unit_clamp(float encoded) noexcept {
    constexpr auto kOne = std::bit_cast<std::int32_t>(1.0f),
                   kInfinite = std::bit_cast<std::int32_t>(std::numeric_limits<float>::infinity());
    const auto bits = std::bit_cast<std::int32_t>(encoded);
    const std::int32_t number = bits & -static_cast<std::int32_t>(bits <= kInfinite);
    return std::bit_cast<float>(std::clamp(number, 0, kOne));
}

}  // namespace emulsion
