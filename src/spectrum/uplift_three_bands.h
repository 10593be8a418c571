#pragma once
// One value for each of three bands of the visible, such that the colour is exact; the simplest uplift there is.
//
// The values come from RGB by a 3x3 matrix, as colours of the three bands under the space's illuminant. Saturated
// colours would need values outside [0, 1]: these are set to 0 or 1, and the colour is then off; greys never are. The
// band edges are those, of all whole nanometres, for which the farthest value outside that a colour in [0, 1]^3 asks
// for is nearest.

#include <array>
#include <string_view>

#include "core/color.h"
#include "core/matrix3.h"
#include "spectrum/reflectance_weights.h"
#include "spectrum/spectrum.h"

namespace emulsion {

struct ThreeBandsUplift {
    static constexpr std::string_view kName = "three-bands";
    static constexpr std::string_view kHelp = "three boxes, exact but for saturated colours, which are clipped";
    bool operator==(const ThreeBandsUplift&) const = default;
};

class ThreeBands {
  public:
    explicit ThreeBands(const ReflectanceRgb& space);

    /// Linear RGB in [0, 1]^3 to values in [0, 1]; greys are constant. The steps between bands take one nanometre, from
    /// edge_nm() on.
    [[nodiscard]] PiecewiseLinearSpectrum reflectance(const RGBd& rgb) const;

    /// Values of the short, middle and long band before clipping.
    [[nodiscard]] std::array<double, 3> unclipped(const RGBd& rgb) const noexcept;

    /// The last whole nanometres of the short and of the middle band.
    [[nodiscard]] const std::array<int, 2>& edge_nm() const noexcept { return edge_nm_; }

  private:
    std::array<int, 2> edge_nm_{};
    Matrix3 band_from_rgb_;
};

[[nodiscard]] inline ThreeBands prepare(const ThreeBandsUplift&, const ReflectanceRgb& space) {
    return ThreeBands(space);
}

}  // namespace emulsion
