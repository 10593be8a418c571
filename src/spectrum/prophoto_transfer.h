#pragma once
// The transfer function of ROMM RGB ("ProPhoto"). For values outside [0, 1] see spectrum/transfer_function.h.

#include <string_view>

namespace emulsion {

/// encode(x) = 16 x for x < 1/512, x^(1/1.8) from there; decode(v) = v / 16 for v < 1/32, v^1.8 from there. The knee is
/// 16^(1.8/(1 - 1.8)) = 1/512, where the pieces meet exactly, with a corner.
/// Source: ISO 22028-2:2013, ROMM RGB, without its viewing flare.
struct ProPhotoTransfer {
    static constexpr std::string_view kName = "prophoto";
    static constexpr std::string_view kHelp = "ROMM RGB, a power of 1.8 with a straight toe";
    static constexpr double kLinearKnee = 1.0 / 512.0;  ///< the first value of the power piece
    static constexpr double kEncodedKnee = 1.0 / 32.0;
    static constexpr double kSlope = 16.0;
    static constexpr double kExponent = 1.8;  ///< of decoding
    bool operator==(const ProPhotoTransfer&) const = default;
};

[[nodiscard]] double encode(const ProPhotoTransfer& transfer, double linear) noexcept;
[[nodiscard]] double decode(const ProPhotoTransfer& transfer, double encoded) noexcept;

/// The upper piece alone, for any linear > 0.
[[nodiscard]] double encode_above_knee(const ProPhotoTransfer& transfer, double linear) noexcept;

}  // namespace emulsion
