#pragma once
// The transfer function of Adobe RGB (1998). For values outside [0, 1] see spectrum/transfer_function.h.

#include <string_view>

#include "spectrum/gamma_transfer.h"

namespace emulsion {

/// encode(x) = x^(256/563), decode(v) = v^(563/256); 563/256 = 2 + 51/256 = 2.19921875.
/// Source: Adobe RGB (1998) Color Image Encoding, version 2005-05.
struct AdobeRgbTransfer {
    static constexpr std::string_view kName = "adobe-rgb";
    static constexpr std::string_view kHelp = "Adobe RGB (1998), a power of 563/256";
    static constexpr GammaTransfer kPower = {563.0 / 256.0};
    bool operator==(const AdobeRgbTransfer&) const = default;
};

[[nodiscard]] inline double encode(const AdobeRgbTransfer& /*transfer*/, double linear) noexcept {
    return encode(AdobeRgbTransfer::kPower, linear);
}
[[nodiscard]] inline double decode(const AdobeRgbTransfer& /*transfer*/, double encoded) noexcept {
    return decode(AdobeRgbTransfer::kPower, encoded);
}

}  // namespace emulsion
