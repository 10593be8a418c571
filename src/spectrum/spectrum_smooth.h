#pragma once
// Spectra given by a formula: constants, and the sigmoids that stand for RGB colours.

#include <array>

#include "spectrum/spectrum_linear.h"
#include "spectrum/spectrum_wavelengths.h"

namespace emulsion {

/// The same value at every wavelength.
struct ConstantSpectrum {
    double value = 0.0;  ///< finite
    bool operator==(const ConstantSpectrum&) const = default;
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
    double scale = 1.0;  ///< finite
    bool operator==(const RgbIlluminantSpectrum&) const = default;
};

/// As many values as wavelengths.
void eval(const ConstantSpectrum& spectrum, const OffsetWavelengths& at, std::span<double> values) noexcept;
void eval(const SigmoidSpectrum& spectrum, const OffsetWavelengths& at, std::span<double> values) noexcept;
void eval(const RgbIlluminantSpectrum& spectrum, const OffsetWavelengths& at, std::span<double> values) noexcept;

/// The wavelengths near which a sigmoid changes fastest, closer and closer around them: an integral cut there can't
/// miss a steep edge or a narrow peak. Only those in (from_nm, to_nm); in no order.
[[nodiscard]] std::vector<double> steep_places_nm(const SigmoidSpectrum& spectrum, double from_nm, double to_nm);

/// \throws std::invalid_argument naming the field, its value and its range.
void validate(const ConstantSpectrum& spectrum);
void validate(const SigmoidSpectrum& spectrum);
void validate(const RgbIlluminantSpectrum& spectrum);

}  // namespace emulsion
