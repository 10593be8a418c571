#pragma once
// Desaturation into the display's gamut.

#include <span>
#include <string_view>

#include "core/color.h"
#include "display/display_gamut.h"
#include "display/gamut_counts.h"

namespace emulsion {

/// On the straight line to the grey of the same luminance, as far as it takes: Y + t (rgb - Y) with the largest t for
/// which all components are in [0, 1]. Luminance and dominant wavelength stay, perceived hue doesn't quite: blues turn
/// purple. Luminances of 1 and more become white, of 0 and less black.
/// The construction is elementary; it is one of those compared in Glassner, Fishkin, Marimont & Stone, "Device-Directed
/// Rendering", ACM Transactions on Graphics 14(1), 1995.
struct GamutDesaturate {
    static constexpr std::string_view kName = "desaturate";
    static constexpr std::string_view kHelp = "toward the grey of the same luminance, just into range";
    bool operator==(const GamutDesaturate&) const = default;
};

/// As map_gamut() in display/gamut_mapper.h, of one colour in double precision and of many in single.
[[nodiscard]] RGBd map_gamut(const GamutDesaturate& mapper, const DisplayGamut& gamut, const RGBd& linear) noexcept;
[[nodiscard]] GamutCounts map_gamut(const GamutDesaturate& mapper, const DisplayGamut& gamut,
                                    std::span<RGB> linear) noexcept;

}  // namespace emulsion
