#pragma once
// Error diffusion.

#include <string_view>

#include "display/code_value.h"
#include "display/component_rows.h"

namespace emulsion {

/// Rounds pixel after pixel, row after row from the top left, and hands the error of each to those not yet rounded:
/// 7/16 right, 3/16 below left, 5/16 below, 1/16 below right. Channels are independent. Errors are differences of
/// encoded values, which keeps the visibility of steps even; the mean of the *encoded* picture is kept, not that of its
/// light.
/// At the border, the shares of pixels outside the picture go to those inside, in proportion to their weights: in the
/// last row all goes right. Only the error of the last pixel is lost. It is below one code unless pixels there are so
/// near to 0 or 1 that no code is left to make the error good.
/// Errors are integers in units of display/code_units.h, and are split without remainder, so that but for that loss the
/// sum of the codes is exactly that of the values, each rounded to such a unit. Source: Floyd & Steinberg, "An Adaptive
/// Algorithm for Spatial Greyscale", Proc. SID 17 (1976).
struct FloydSteinberg {
    static constexpr std::string_view kName = "floyd-steinberg";
    static constexpr std::string_view kHelp = "error diffusion in raster order, in encoded values";
    bool operator==(const FloydSteinberg&) const = default;
};

/// As quantize() in display/dither.h; serial, `threads` is not used.
void quantize(const FloydSteinberg& dither, const EncodedRows& encoded, const CodeScale& scale, const CodeRows& codes,
              int threads);

}  // namespace emulsion
