#pragma once
// Spectra for linear RGB colours, by any of several methods. A reflectance "has" an RGB colour if, under the space's
// illuminant and for the CIE 1931 observer, it looks so, with the perfect reflector at (1, 1, 1).
//
//     RgbUplift(rgb_space("sRGB"), BasisUplift{}).reflectance({0.8, 0.1, 0.05})
//
// docs/rgb-uplift.md compares the methods: how exact they are, how they fare under other illuminants, how smooth they
// are and what they cost. To add one, write a named value with an overload of prepare(), which makes something that has
// reflectance(RGBd), and add it to UpliftMethod.

#include <string>
#include <variant>

#include "core/color.h"
#include "core/named_value.h"
#include "spectrum/reflectance_weights.h"
#include "spectrum/rgb_space.h"
#include "spectrum/spectrum.h"
#include "spectrum/uplift_basis.h"
#include "spectrum/uplift_sigmoid.h"
#include "spectrum/uplift_smits.h"
#include "spectrum/uplift_three_bands.h"

namespace emulsion {

using UpliftMethod = std::variant<SigmoidUplift, SigmoidTableUplift, SmitsUplift, BasisUplift, ThreeBandsUplift>;

/// What prepare() makes of each method.
template <class Variant>
struct PreparedUplifts;
template <class... Methods>
struct PreparedUplifts<std::variant<Methods...>> {
    using Type = std::variant<decltype(prepare(Methods{}, std::declval<const ReflectanceRgb&>()))...>;
};

/// A method, made ready for one space. Const functions may be called from many threads.
class RgbUplift {
  public:
    /// \throws std::invalid_argument as illuminant_of and xyz_from_rgb do, and if the method can't serve the space:
    /// "sigmoid-table" without a table, "mallett-yuksel" where no such basis exists (all spaces much wider than sRGB).
    explicit RgbUplift(const RgbSpace& space, const UpliftMethod& method = SigmoidUplift{});

    /// The reflectance of a linear RGB colour in [0, 1]^3, with values in [0, 1]. Greys are constant.
    /// \throws std::invalid_argument if a component is outside [0, 1] or not finite.
    [[nodiscard]] Spectrum reflectance(const RGBd& rgb) const;

    /// A spectrum without an upper bound (of a scattering coefficient, say), as pbrt-v4's RGBUnboundedSpectrum: with m
    /// the largest component, 2 m times the reflectance of rgb / (2 m). Black is 0.
    /// \throws std::invalid_argument if a component is negative or not finite, or if 2 m is not.
    [[nodiscard]] Spectrum unbounded(const RGBd& rgb) const;

    /// The spectrum of a light, as pbrt-v4's RGBIlluminantSpectrum: the unbounded one times the space's illuminant.
    /// Divided by kLuminousEfficacy * light_normalisation(), it has the XYZ of the colour, with Y = 1 for (1, 1, 1).
    /// \throws std::invalid_argument as unbounded() does.
    [[nodiscard]] Spectrum light(const RGBd& rgb) const;

    /// The photometric integral (colorimetry.h) of the space's illuminant: lights of all colours are divided by the
    /// same number, so that they keep their luminance.
    [[nodiscard]] double light_normalisation() const;

    /// The linear RGB of a reflectance; straight lines between whole nanometres.
    [[nodiscard]] RGBd rgb_of(const Spectrum& reflectance) const noexcept;

    [[nodiscard]] const PiecewiseLinearSpectrum& illuminant() const noexcept { return space_.illuminant; }

  private:
    ReflectanceRgb space_;
    PreparedUplifts<UpliftMethod>::Type method_;
};

/// RgbUplift(space).reflectance(rgb), for a single colour.
[[nodiscard]] SigmoidSpectrum fit_sigmoid(const RGBd& reflectance, const RgbSpace& space);

/// RgbUplift(space).light(rgb), for a single colour.
[[nodiscard]] RgbIlluminantSpectrum rgb_illuminant(const RGBd& light, const RgbSpace& space);

}  // namespace emulsion
