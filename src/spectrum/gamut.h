#pragma once
// What an RGB space can show: chromaticities inside the triangle of its primaries (at some luminance), and colours
// inside its cube (at their own).

#include <vector>

#include "core/color.h"
#include "core/matrix3.h"
#include "spectrum/chromaticity.h"
#include "spectrum/rgb_space.h"

namespace emulsion {

class RgbGamut {
  public:
    /// \throws std::invalid_argument as xyz_from_rgb does.
    explicit RgbGamut(const RgbSpace& space);

    /// Distance in x, y of a chromaticity from the triangle's border: positive inside, negative outside; on the border
    /// rounding decides (1e-16). NaN for NaN.
    [[nodiscard]] double signed_distance(const Chromaticity& chromaticity) const noexcept;

    /// How far linear RGB lies from the surface of the cube [0, 1]^3, in units of its edge: positive inside (at most
    /// 0.5, at mid grey), negative outside (by how much the worst component is below 0 or above 1). XYZ has Y = 1 at
    /// the space's white; on the surface rounding decides (1e-15). NaN if a component is NaN.
    [[nodiscard]] double margin(const XYZd& xyz) const noexcept;

  private:
    std::vector<Chromaticity> triangle_;  // counter-clockwise
    Matrix3 rgb_from_xyz_;
};

/// The same of linear RGB itself.
[[nodiscard]] double gamut_margin(const RGBd& rgb) noexcept;

}  // namespace emulsion
