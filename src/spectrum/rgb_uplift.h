#pragma once
// Smooth spectra for linear RGB colours. A reflectance "has" an RGB colour if, under the space's illuminant and for the
// CIE 1931 observer, it looks so, with the perfect reflector at (1, 1, 1).
// Source: Jakob & Hanika, "A Low-Dimensional Function Space for Efficient Spectral Upsampling", EG 2019. They tabulate
// the coefficients; here every colour is solved for directly, in some fifty microseconds.

#include "core/color.h"
#include "core/matrix3.h"
#include "spectrum/rgb_space.h"
#include "spectrum/sigmoid_solver.h"
#include "spectrum/spectrum.h"

namespace emulsion {

/// The illuminant of a space: D65 as tabulated (CIE 15:2004, 300-830 nm) if its white is that of D65 to 5e-4 in x and
/// y; for every other white, the mixture of the CIE daylight components that has its chromaticity. \throws
/// std::invalid_argument as daylight() does.
[[nodiscard]] PiecewiseLinearSpectrum illuminant_of(const RgbSpace& space);

/// Fits sigmoid spectra to colours of one space. Const functions may be called from many threads.
class RgbUplift {
  public:
    /// \throws std::invalid_argument as illuminant_of and xyz_from_rgb do.
    explicit RgbUplift(const RgbSpace& space);

    /// The reflectance of a linear RGB colour in [0, 1]^3. Greys are constant. All of sRGB is reached; the most
    /// saturated colours of wider spaces lie outside what any reflectance can be, and get a sigmoid with little CIELAB
    /// difference (a local minimum of it). \throws std::invalid_argument if a component is outside [0, 1] or not
    /// finite.
    [[nodiscard]] SigmoidSpectrum reflectance(const RGBd& rgb) const;

    /// The spectrum of a light of linear RGB colour, as pbrt-v4 takes it: with m the largest component, scale = 2 m and
    /// the sigmoid of rgb / (2 m), times the illuminant. Black has scale 0.
    /// \throws std::invalid_argument if a component is negative or not finite.
    [[nodiscard]] RgbIlluminantSpectrum light(const RGBd& rgb) const;

    /// The linear RGB of a reflectance: what the fit compares; straight lines between whole nanometres.
    [[nodiscard]] RGBd rgb_of(const Spectrum& reflectance) const noexcept;

  private:
    PiecewiseLinearSpectrum illuminant_;
    ReflectanceWeights weights_;
    Matrix3 relative_xyz_from_rgb_, rgb_from_relative_xyz_;
};

/// RgbUplift(space).reflectance(rgb), for a single colour.
[[nodiscard]] SigmoidSpectrum fit_sigmoid(const RGBd& reflectance, const RgbSpace& space);

/// RgbUplift(space).light(rgb), for a single colour.
[[nodiscard]] RgbIlluminantSpectrum rgb_illuminant(const RGBd& light, const RgbSpace& space);

}  // namespace emulsion
