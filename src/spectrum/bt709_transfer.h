#pragma once
// The camera curve of standard television. For "linear", "encoded" and values outside [0, 1] see
// spectrum/transfer_function.h. Displays don't undo it: see spectrum/bt1886_transfer.h.

#include <string_view>

namespace emulsion {

/// encode(x) = 4.5 x for x < 0.018, 1.099 x^0.45 - 0.099 from there; linear is light in the scene.
/// Source: ITU-R BT.709-6, 1.2, with the same constants as BT.601-7 and as BT.2020-2 for 10-bit systems (12-bit ones:
/// spectrum/bt2020_transfer.h). They are rounded: at the knee the encoded value rises by 2.479e-4, from 0.081 to
/// 0.081248. The standard has no decode: ours takes the codes of this gap, which no light has, to the knee, so that it
/// undoes encode everywhere and never falls. The algebraic inverse alone falls by 5.5e-5 at one of the gap's ends.
struct Bt709Transfer {
    static constexpr std::string_view kName = "bt709";
    static constexpr std::string_view kHelp = "camera curve of BT.601, BT.709 and 10-bit BT.2020";
    static constexpr double kLinearKnee = 0.018;  ///< the first value of the power piece
    static constexpr double kSlope = 4.5;
    static constexpr double kScale = 1.099;    ///< of the power piece
    static constexpr double kExponent = 0.45;  ///< of encoding
    bool operator==(const Bt709Transfer&) const = default;
};

[[nodiscard]] double encode(const Bt709Transfer& transfer, double linear) noexcept;
[[nodiscard]] double decode(const Bt709Transfer& transfer, double encoded) noexcept;

/// The upper piece alone, for any linear > 0.
[[nodiscard]] double encode_above_knee(const Bt709Transfer& transfer, double linear) noexcept;

}  // namespace emulsion
