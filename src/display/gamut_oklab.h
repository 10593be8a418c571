#pragma once
// Compression of chroma into the display's gamut.

#include <span>
#include <string_view>

#include "core/color.h"
#include "display/display_gamut.h"
#include "display/gamut_counts.h"

namespace emulsion {

/// Lightness and hue in Oklab of the light that the display shows, its black and the room's light with it, stay to 4
/// degrees and 0.01, while chroma shrinks to the boundary of the gamut. Lightnesses of white and more become white, of
/// black and less black. The display's white is adapted to Oklab's own, so that greys are greys.
///
/// Along the line of constant lightness and hue each component of linear RGB is a cubic polynomial of chroma, so that
/// boundaries are found to the last bits of double precision. The line alone would leap: near the blue corners of sRGB
/// and BT.2020 it leaves the gamut and just comes in again at a higher chroma, or just not. So it stops at the mean of
/// the places where bounds are broken by 2% to 12% of the grey's distance from them (display/gamut_bound.h), and what
/// is broken then is clipped. With that the map is continuous on every display: monochromatic light from 440 to 500 nm
/// changes by 25 8-bit codes at most in 0.1 nm on every preset, and by 4 in 0.01 nm. More chroma in may give up to
/// 0.02 less out, for chromas up to 1.2 times the lightness. Those limits of hue and lightness are for the presets, in
/// any room, and chromas above 0.02; on displays with primaries far off them, whose gamut the line may leave for longer
/// before it comes in again, clipping there may change hue by tens of degrees. Source: Ottosson, "A perceptual color
/// space for image processing", 2020, and "sRGB gamut clipping", 2021, "keep lightness constant, only compress chroma",
/// https://bottosson.github.io/posts/gamutclipping; there one step of Halley's method finds the boundary of sRGB, and
/// its leap is left. Clipping what is but little outside is the idea of CSS Color Module Level 4, 13.2, whose own rule
/// isn't continuous either.
struct GamutOklab {
    static constexpr std::string_view kName = "oklab";
    static constexpr std::string_view kHelp = "less chroma at about the lightness and hue of Oklab, just into range";
    bool operator==(const GamutOklab&) const = default;
};

/// As map_gamut() in display/gamut_mapper.h, of one colour in double precision and of many in single.
[[nodiscard]] RGBd map_gamut(const GamutOklab& mapper, const DisplayGamut& gamut, const RGBd& linear) noexcept;
[[nodiscard]] GamutCounts map_gamut(const GamutOklab& mapper, const DisplayGamut& gamut,
                                    std::span<RGB> linear) noexcept;

}  // namespace emulsion
