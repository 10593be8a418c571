#include "display/srgb_transfer.h"

#include <cmath>

namespace emulsion {

namespace {

constexpr double kSlope = 12.92;
constexpr double kScale = 1.055;
constexpr double kOffset = 0.055;
constexpr double kExponent = 2.4;
constexpr double kLinearKnee = 0.0031308;
constexpr double kEncodedKnee = 0.04045;

float encode_fast(float linear) noexcept {
    if (linear <= static_cast<float>(kLinearKnee)) return static_cast<float>(kSlope) * linear;
    return static_cast<float>(kScale) * std::pow(linear, static_cast<float>(1.0 / kExponent)) -
           static_cast<float>(kOffset);
}

}  // namespace

double encode(const SrgbTransfer& /*transfer*/, double linear) noexcept {
    if (linear <= kLinearKnee) return kSlope * linear;
    return kScale * std::pow(linear, 1.0 / kExponent) - kOffset;
}

double decode(const SrgbTransfer& /*transfer*/, double encoded) noexcept {
    if (encoded <= kEncodedKnee) return encoded / kSlope;
    return std::pow((encoded + kOffset) / kScale, kExponent);
}

void encode(const SrgbTransfer& /*transfer*/, std::span<RGB> linear) noexcept {
    for (RGB& rgb : linear) rgb = {encode_fast(rgb.r), encode_fast(rgb.g), encode_fast(rgb.b)};
}

}  // namespace emulsion
