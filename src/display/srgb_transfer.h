#pragma once
// The sRGB transfer function. Linear values are proportional to light, encoded values are those of the code: both in
// [0, 1]. encode: linear to encoded; decode: back.

#include <span>
#include <string_view>

#include "core/color.h"

namespace emulsion {

/// encode(x) = 12.92 x for x <= 0.0031308, 1.055 x^(1/2.4) - 0.055 above;
/// decode(v) = v / 12.92 for v <= 0.04045, ((v + 0.055) / 1.055)^2.4 above.
/// Source: IEC 61966-2-1:1999, with its constants as printed, which are rounded: at the knee the encoded value falls by
/// 2.9e-8 (0.002 of a 16-bit code), and the two functions are inverse to 3e-8 near it.
struct SrgbTransfer {
    static constexpr std::string_view kName = "srgb";
    static constexpr std::string_view kHelp = "IEC 61966-2-1, near a power of 2.2";
    bool operator==(const SrgbTransfer&) const = default;
};

/// The specification, in double precision; 0 and 1 exactly to themselves. Argument in [0, 1].
[[nodiscard]] double encode(const SrgbTransfer& transfer, double linear) noexcept;
[[nodiscard]] double decode(const SrgbTransfer& transfer, double encoded) noexcept;

/// In place, in single precision: within 6e-8 of the specification (0.004 of a 16-bit code), 0 and 1 exactly to
/// themselves, rising but for the step at the knee: measured over every float of [0.0005, 1]. Components in [0, 1].
void encode(const SrgbTransfer& transfer, std::span<RGB> linear) noexcept;

}  // namespace emulsion
