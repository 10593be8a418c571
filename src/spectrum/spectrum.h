#pragma once
// Spectra as plain values: functions of the wavelength in nm, dimensionless (reflectances), in
// W m^-2 sr^-1 nm^-1 (radiances), or relative, as said where they are used. Double precision.

#include <array>
#include <variant>
#include <vector>

namespace emulsion {

/// The same value at every wavelength.
struct ConstantSpectrum {
    double value = 0.0;
    bool operator==(const ConstantSpectrum&) const = default;
};

/// Straight lines between knots, and 0 outside them (as pbrt-v4 takes the "spectrum" parameters of a scene).
struct PiecewiseLinearSpectrum {
    std::vector<double> lambda_nm;  ///< at least one, finite, strictly increasing
    std::vector<double> value;      ///< as many, finite
    bool operator==(const PiecewiseLinearSpectrum&) const = default;
};

/// Planck's law, scaled to a maximum of 1 over all wavelengths.
/// Source: CIE 15:2004; constants of the SI, 2019.
struct BlackbodySpectrum {
    double temperature_K = 6500.0;  ///< > 0
    bool operator==(const BlackbodySpectrum&) const = default;
};

/// A smooth reflectance in (0, 1): sigmoid(c0 t^2 + c1 t + c2), with t = (lambda - 360 nm) / 470 nm and
/// sigmoid(x) = 1/2 + x / (2 sqrt(1 + x^2)).
/// Source: Jakob & Hanika, "A Low-Dimensional Function Space for Efficient Spectral Upsampling", EG 2019, eq. 3-4.
struct SigmoidSpectrum {
    std::array<double, 3> c{};  ///< an infinite c2 stands for the constants 0 and 1
    bool operator==(const SigmoidSpectrum&) const = default;
};

/// A sigmoid times a tabulated illuminant times a scale: an RGB light.
struct RgbIlluminantSpectrum {
    SigmoidSpectrum sigmoid;
    PiecewiseLinearSpectrum illuminant;
    double scale = 1.0;
    bool operator==(const RgbIlluminantSpectrum&) const = default;
};

using Spectrum =
    std::variant<ConstantSpectrum, PiecewiseLinearSpectrum, BlackbodySpectrum, SigmoidSpectrum, RgbIlluminantSpectrum>;

/// The value at one wavelength, nm > 0. At a knot with a jump (the ends of a piecewise linear spectrum) the knot's
/// value.
[[nodiscard]] double eval(const Spectrum& spectrum, double lambda_nm) noexcept;

/// Which side a limit is taken from: shorter or longer wavelengths.
enum class Side { below, above };

/// The value that the spectrum tends to at lambda_nm from one side. Differs from eval only at the ends of a piecewise
/// linear spectrum, from outside: there it is 0.
[[nodiscard]] double limit(const Spectrum& spectrum, double lambda_nm, Side side) noexcept;

/// The wavelengths at which the spectrum has a kink or a jump, increasing; it is smooth in between.
[[nodiscard]] std::vector<double> knots_nm(const Spectrum& spectrum);

/// \throws std::invalid_argument naming the field, its value and its range.
void validate(const Spectrum& spectrum);

}  // namespace emulsion
