#pragma once
// Boxes for every RGB colour: ten bins between 380 and 720 nm, seven spectra, and any colour as white plus one
// secondary plus one primary. Source: Smits, "An RGB-to-Spectrum Conversion for Reflectances", Journal of Graphics
// Tools 4(4), 1999. Method and bins are his; the numbers are our own, solved for each space (his are for phosphors with
// a white of equal energy, and exceed 1 in places). Where ten bins within [0, 1] cannot have the colour of a primary or
// secondary, the basis has the nearest in linear RGB; he let it exceed 1.

#include <array>
#include <string_view>

#include "core/color.h"
#include "spectrum/reflectance_weights.h"
#include "spectrum/spectrum.h"

namespace emulsion {

struct SmitsUplift {
    static constexpr std::string_view kName = "smits";
    static constexpr std::string_view kHelp = "ten boxes: white, one secondary and one primary";
    bool operator==(const SmitsUplift&) const = default;
};

class SmitsBasis {
  public:
    static constexpr int kBins = 10;
    static constexpr int kFirst_nm = 380, kBinWidth_nm = 34;  ///< the outer bins go on to the ends of the visible

    explicit SmitsBasis(const ReflectanceRgb& space);

    /// Linear RGB in [0, 1]^3 to values in [0, 1]; greys are constant. The steps between bins take one nanometre, from
    /// the whole nanometre of the edge on.
    [[nodiscard]] PiecewiseLinearSpectrum reflectance(const RGBd& rgb) const;

  private:
    using Bins = std::array<double, kBins>;
    std::array<Bins, 3> primary_{};    // red, green, blue
    std::array<Bins, 3> secondary_{};  // cyan, magenta, yellow: white without the primary of this number
};

[[nodiscard]] inline SmitsBasis prepare(const SmitsUplift&, const ReflectanceRgb& space) { return SmitsBasis(space); }

}  // namespace emulsion
