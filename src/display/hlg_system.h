#pragma once
// The system gamma of hybrid log-gamma television: from the light that a display shows back to that of the scene, which
// is what HLG encodes. Both are linear RGB, relative, 1 for white.

#include <cstdint>
#include <span>

#include "core/color.h"
#include "display/curve_table.h"

namespace emulsion {

/// gamma = 1.2 + 0.42 log10(peak / 1000 cd/m^2). Source: ITU-R BT.2100-2, table 5, note 5f; for 400 to 2000 cd/m^2.
[[nodiscard]] double hlg_system_gamma(double peak_cdm2) noexcept;

/// What the display adds to codes so that code 0 shows its black: it decodes (1 - beta) E' + beta, with
/// beta = sqrt(3 (black / peak)^(1/gamma)). Source: ITU-R BT.2100-2, table 5. \param black black / peak
[[nodiscard]] double hlg_black_lift(double gamma, double black) noexcept;

/// The inverse OOTF: E = F Ys / Yd with Yd the luminance of F and Ys = Yd^(1/gamma), so that F = Ys^(gamma - 1) E.
/// Greys stay grey. HLG can't show the brightest saturated colours: a full blue would take an E of 1.6. They go toward
/// the grey of their luminance until the largest component is 1, so that luminance and dominant wavelength stay.
/// Source: ITU-R BT.2100-2, table 5. \param luminance of each primary; they add up to 1 \param shown components in
/// [0, 1]
[[nodiscard]] RGBd hlg_scene_light(double gamma, const RGBd& luminance, const RGBd& shown) noexcept;

/// The same for pictures, in place and in single precision: within 2e-7 of the twin.
class HlgSceneLight {
  public:
    HlgSceneLight(double gamma, const RGBd& luminance);

    /// \return how many pixels HLG can't show, by more than kGamutTolerance.
    [[nodiscard]] std::int64_t operator()(std::span<RGB> shown) const noexcept;

  private:
    double gamma_;
    RGBd luminance_;
    CurveTable scene_luminance_;
};

}  // namespace emulsion
