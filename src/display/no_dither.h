#pragma once
// Rounding to the nearest code.

#include <string_view>

#include "core/color.h"
#include "core/image.h"
#include "display/code_value.h"

namespace emulsion {

/// Each component to the nearest code by itself, halves up. Smooth ramps show steps.
struct NoDither {
    static constexpr std::string_view kName = "none";
    static constexpr std::string_view kHelp = "round to the nearest code";
    bool operator==(const NoDither&) const = default;
};

/// As quantize() in display/dither.h.
void quantize(const NoDither& dither, ImageView<const RGB> encoded, const CodeScale& scale, ImageView<CodeRGB> codes,
              int threads);

}  // namespace emulsion
