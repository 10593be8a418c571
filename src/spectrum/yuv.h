#pragma once
// Y'UV of PAL, of encoded RGB. For luma see spectrum/luma.h.

#include <array>
#include <string_view>

#include "core/color.h"
#include "spectrum/color_values.h"

namespace emulsion {

/// Nothing to do with the chromaticities u, v.
struct Yuv {
    double luma = 0.0;  ///< Y', 0 black, 1 white
    double u = 0.0;     ///< 0 for greys, within 0.436
    double v = 0.0;     ///< 0 for greys, within 0.615
    bool operator==(const Yuv&) const = default;
};

/// Keep the modulated signal within 33% of white and black. Books have also 0.492111 and 0.877283, from which these are
/// rounded.
inline constexpr double kYuvScaleOfU = 0.492;
inline constexpr double kYuvScaleOfV = 0.877;

/// Y' = 0.299 R' + 0.587 G' + 0.114 B', U = 0.492 (B' - Y'), V = 0.877 (R' - Y'), for every RGB. "U = B' - Y'" alone is
/// unscaled. Source: ITU-R BT.470-6 (whose U has 0.493).
[[nodiscard]] Yuv yuv_from_rgb(const RGBd& encoded) noexcept;
[[nodiscard]] RGBd rgb_from_yuv(const Yuv& yuv) noexcept;

struct YuvSystem {
    static constexpr std::string_view kName = "yuv";
    static constexpr std::string_view kHelp = "Y'UV of PAL, from encoded RGB";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = {ColorComponent{"Y'", 0.0, 1.0, "", "luma"},
                                               ColorComponent{"U", -0.436, 0.436, "", "0.492 (B' - Y')"},
                                               ColorComponent{"V", -0.6148, 0.6148, "", "0.877 (R' - Y')"}};
    bool operator==(const YuvSystem&) const = default;
};
[[nodiscard]] ColorValues from_xyz(const YuvSystem& system, const XYZd& xyz, const ColorContext& context) noexcept;
[[nodiscard]] XYZd to_xyz(const YuvSystem& system, const ColorValues& color, const ColorContext& context) noexcept;

}  // namespace emulsion
