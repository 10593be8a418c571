#pragma once
// Three smooth reflectances, of red, green and blue, that add up to 1: any colour is their sum, weighted by its RGB.
// Source: Mallett & Yuksel, "Spectral Primary Decomposition for Rendering with sRGB Reflectance", EGSR 2019. The
// conditions are theirs: exact colours, nowhere below 0, a sum of 1. Of all such bases ours has the least squared
// slope, so that its edges are gentle and its ends flat; the one that they tabulate for sRGB has steeper edges, and
// tends to 1/3 where the eye sees next to nothing. Most spaces wider than sRGB have no such basis: their primaries are
// more saturated than any reflectance.

#include <array>
#include <string_view>
#include <vector>

#include "core/color.h"
#include "spectrum/reflectance_weights.h"
#include "spectrum/spectrum.h"

namespace emulsion {

struct BasisUplift {
    static constexpr std::string_view kName = "mallett-yuksel";
    static constexpr std::string_view kHelp = "three smooth spectra that add up to 1; sRGB and no wider";
    bool operator==(const BasisUplift&) const = default;
};

class PrimaryBasis {
  public:
    static constexpr int kStep_nm = 5;  ///< between knots

    /// \throws std::invalid_argument if the space has no such basis.
    explicit PrimaryBasis(const ReflectanceRgb& space);

    /// Linear RGB in [0, 1]^3 to values in [0, 1]: exact, and linear in RGB.
    [[nodiscard]] PiecewiseLinearSpectrum reflectance(const RGBd& rgb) const;

  private:
    std::vector<double> lambda_nm_;
    std::array<std::vector<double>, 3> primary_;  // at lambda_nm_; their sum is 1
};

[[nodiscard]] inline PrimaryBasis prepare(const BasisUplift&, const ReflectanceRgb& space) {
    return PrimaryBasis(space);
}

}  // namespace emulsion
