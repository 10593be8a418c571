#pragma once
// The camera curve of ultra high definition television in 12 bits. For "linear", "encoded" and values outside [0, 1]
// see spectrum/transfer_function.h.

#include <string_view>

namespace emulsion {

/// encode(x) = 4.5 x for x < 0.0181, 1.0993 x^0.45 - 0.0993 from there; linear is light in the scene.
/// Source: ITU-R BT.2020-2, table 4, with the constants that it gives for 12-bit systems (those for 10-bit ones are
/// BT.709's: spectrum/bt709_transfer.h). They are rounded: at the knee the encoded value falls by 2.80e-6 (0.01 of a
/// 12-bit code), and decode undoes encode to 7e-7 near it, elsewhere to rounding.
struct Bt2020Transfer {
    static constexpr std::string_view kName = "bt2020";
    static constexpr std::string_view kHelp = "camera curve of 12-bit BT.2020";
    static constexpr double kLinearKnee = 0.0181;  ///< the first value of the power piece
    static constexpr double kSlope = 4.5;
    static constexpr double kScale = 1.0993;   ///< of the power piece
    static constexpr double kExponent = 0.45;  ///< of encoding
    bool operator==(const Bt2020Transfer&) const = default;
};

[[nodiscard]] double encode(const Bt2020Transfer& transfer, double linear) noexcept;
[[nodiscard]] double decode(const Bt2020Transfer& transfer, double encoded) noexcept;

/// The upper piece alone, for any linear > 0.
[[nodiscard]] double encode_above_knee(const Bt2020Transfer& transfer, double linear) noexcept;

}  // namespace emulsion
