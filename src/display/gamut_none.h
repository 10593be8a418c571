#pragma once
// No gamut mapping.

#include <span>
#include <string_view>

#include "core/color.h"
#include "display/display_gamut.h"
#include "display/gamut_counts.h"

namespace emulsion {

/// Components as they are, but for NaN, which becomes 0. Quantization takes those outside [0, 1] as the nearest value
/// inside, so that codes are those of clipping; what there is outside is counted all the same.
struct GamutNone {
    static constexpr std::string_view kName = "none";
    static constexpr std::string_view kHelp = "none, but colours outside are counted; codes end at black and white";
    bool operator==(const GamutNone&) const = default;
};

/// As map_gamut() in display/gamut_mapper.h, but what lies outside stays there.
[[nodiscard]] RGBd map_gamut(const GamutNone& mapper, const DisplayGamut& gamut, const RGBd& linear) noexcept;
[[nodiscard]] GamutCounts map_gamut(const GamutNone& mapper, const DisplayGamut& gamut, std::span<RGB> linear) noexcept;

}  // namespace emulsion
