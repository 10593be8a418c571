#pragma once
// The sRGB transfer function. For "linear", "encoded" and values outside [0, 1] see spectrum/transfer_function.h.

#include <string_view>

namespace emulsion {

/// encode(x) = 12.92 x for x <= 0.0031308, 1.055 x^(1/2.4) - 0.055 above;
/// decode(v) = v / 12.92 for v <= 0.04045, ((v + 0.055) / 1.055)^2.4 above.
/// Source: IEC 61966-2-1:1999, with its constants as printed, which are rounded: at the knee the encoded value falls by
/// 2.9e-8 (0.002 of a 16-bit code), and the two functions are inverse to 3e-8 near it.
struct SrgbTransfer {
    static constexpr std::string_view kName = "srgb";
    static constexpr std::string_view kHelp = "IEC 61966-2-1, near a power of 2.2";
    static constexpr double kLinearKnee = 0.0031308;  ///< the last value of the straight piece
    static constexpr double kEncodedKnee = 0.04045;
    static constexpr double kSlope = 12.92;
    static constexpr double kScale = 1.055;   ///< of the power piece
    static constexpr double kExponent = 2.4;  ///< of decoding
    bool operator==(const SrgbTransfer&) const = default;
};

[[nodiscard]] double encode(const SrgbTransfer& transfer, double linear) noexcept;
[[nodiscard]] double decode(const SrgbTransfer& transfer, double encoded) noexcept;

/// The upper piece alone, for any linear > 0.
[[nodiscard]] double encode_above_knee(const SrgbTransfer& transfer, double linear) noexcept;

}  // namespace emulsion
