#pragma once
// Compression of chroma into the display's gamut.

#include <span>
#include <string_view>

#include "core/color.h"
#include "display/display_gamut.h"
#include "display/gamut_counts.h"

namespace emulsion {

/// Lightness and hue of Oklab stay, chroma shrinks to the boundary of the gamut. Along that line each component of
/// linear RGB is a cubic polynomial of chroma, so that the boundary is found to the last bits of double precision: of
/// its places on the line the outermost, where the line meets it more than once. Lightnesses of 1 and more become
/// white, of 0 and less black. The display's white is adapted to Oklab's own, so that greys are greys.
/// Source: Ottosson, "A perceptual color space for image processing", 2020, and "sRGB gamut clipping", 2021, "keep
/// lightness constant, only compress chroma", https://bottosson.github.io/posts/gamutclipping; there one step of
/// Halley's method finds the boundary of sRGB.
struct GamutOklab {
    static constexpr std::string_view kName = "oklab";
    static constexpr std::string_view kHelp = "less chroma at the lightness and hue of Oklab, just into range";
    bool operator==(const GamutOklab&) const = default;
};

/// As map_gamut() in display/gamut_mapper.h, of one colour in double precision and of many in single.
[[nodiscard]] RGBd map_gamut(const GamutOklab& mapper, const DisplayGamut& gamut, const RGBd& linear) noexcept;
[[nodiscard]] GamutCounts map_gamut(const GamutOklab& mapper, const DisplayGamut& gamut,
                                    std::span<RGB> linear) noexcept;

}  // namespace emulsion
