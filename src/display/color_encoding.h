#pragma once
// What code values mean: which light a display shows for them. Files say so by their colour chunks.

#include "display/code_value.h"
#include "display/display.h"
#include "spectrum/rgb_space.h"
#include "spectrum/transfer_function.h"

namespace emulsion {

/// Linear RGB of `space` (CIE 1931 x, y), of which 1 is white, through the transfer function into codes of the range.
struct ColorEncoding {
    RgbSpace space = rgb_space("sRGB");
    TransferFunction transfer = SrgbTransfer{};
    CodeRange range = FullRange{};
    bool operator==(const ColorEncoding&) const = default;
};

/// Of these three stages of a Pipeline.
[[nodiscard]] ColorEncoding color_encoding(const Display& display, const TransferFunction& transfer,
                                           const CodeRange& range);

}  // namespace emulsion
