#pragma once
// The system gamma of hybrid log-gamma television: from the light that a display shows back to that of the scene, which
// is what HLG encodes. Both are linear RGB, relative, 1 for white.

#include <span>

#include "core/color.h"
#include "display/curve_table.h"

namespace emulsion {

/// gamma = 1.2 + 0.42 log10(peak / 1000 cd/m^2). Source: ITU-R BT.2100-2, table 5, note 5f; for 400 to 2000 cd/m^2.
[[nodiscard]] double hlg_system_gamma(double peak_cdm2) noexcept;

/// The inverse OOTF: E = F Ys / Yd with Yd the luminance of F and Ys = Yd^(1/gamma), so that F = Ys^(gamma - 1) E.
/// Greys stay grey. Saturated bright colours, of which HLG can't show the brightest, end at 1: a full blue would
/// take 1.6. Source: ITU-R BT.2100-2, table 5. \param luminance of each primary; they add up to 1 \param shown
/// components in [0, 1]
[[nodiscard]] RGBd hlg_scene_light(double gamma, const RGBd& luminance, const RGBd& shown) noexcept;

/// The same for pictures, in place and in single precision: within 2e-7 of the twin.
class HlgSceneLight {
  public:
    HlgSceneLight(double gamma, const RGBd& luminance);

    void operator()(std::span<RGB> shown) const noexcept;

  private:
    RGB luminance_;
    CurveTable scene_luminance_;
};

}  // namespace emulsion
