#pragma once
// Rounding to the nearest code.

#include <string_view>

#include "display/code_value.h"
#include "display/component_rows.h"
#include "display/encoded_source.h"

namespace emulsion {

/// Each component to the nearest code by itself, halves up. Smooth ramps show steps.
struct NoDither {
    static constexpr std::string_view kName = "none";
    static constexpr std::string_view kHelp = "round to the nearest code";
    bool operator==(const NoDither&) const = default;
};

/// As quantize() in display/dither.h.
void quantize(const NoDither& dither, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
              int threads);

}  // namespace emulsion
