#pragma once
// How a PNG says what its code values mean: the shortest chunks that say all of it.

#include <cstdint>
#include <string>
#include <variant>

#include "display/color_encoding.h"

namespace emulsion {

/// sRGB (intent: relative colorimetric, since the picture has been brought into the gamut on purpose and is to be shown
/// as it is) and the gAMA and cHRM that go with it.
struct PngSrgb {
    bool operator==(const PngSrgb&) const = default;
};

/// gAMA and cHRM: a pure power.
struct PngGamma {
    double exponent = 2.2;  ///< of decoding
    RgbSpace space;
    bool operator==(const PngGamma&) const = default;
};

/// iCCP: a matrix and any curve.
struct PngProfile {
    std::string icc;
    bool operator==(const PngProfile&) const = default;
};

/// cICP: numbers of ITU-T H.273. For RGB the third, of the matrix, is always 0.
/// Source: Portable Network Graphics (Third Edition), W3C, 11.3.2.6.
struct PngCodePoints {
    std::uint8_t primaries = 1, transfer = 13;
    bool full_range = true;
    bool operator==(const PngCodePoints&) const = default;
};

using PngColor = std::variant<PngSrgb, PngGamma, PngProfile, PngCodePoints>;

/// PngSrgb for sRGB; PngGamma for linear light, pure powers and BT.1886 without a black of its own; PngCodePoints for
/// PQ, HLG and every narrow range, which nothing else can say; PngProfile for the rest, and for primaries of a pure
/// power that gAMA and cHRM can't say (an x or y below 0 or above 0.8, or x + y above 1: cHRM has whole numbers of
/// 1e-5). \throws std::invalid_argument naming what no chunk says: for PngCodePoints primaries or transfer functions
/// without a number in H.273, BT.1886 among them, which has none as it is no camera's.
[[nodiscard]] PngColor png_color(const ColorEncoding& encoding);

}  // namespace emulsion
