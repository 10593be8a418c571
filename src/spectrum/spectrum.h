#pragma once
// Spectra as plain values: functions of the wavelength in nm, dimensionless (reflectances), in
// W m^-2 sr^-1 nm^-1 (radiances), or relative, as said where they are used. Double precision.
//
// A spectrum is a continuum, which has a value at every wavelength, and a number of lines without width, which have a
// power. eval, limit and knots_nm are about the continuum alone; integrals (spectrum/integral.h) and everything made of
// them know both.

#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "spectrum/blackbody.h"
#include "spectrum/spectrum_compound.h"
#include "spectrum/spectrum_daylight.h"
#include "spectrum/spectrum_linear.h"
#include "spectrum/spectrum_lines.h"
#include "spectrum/spectrum_smooth.h"
#include "spectrum/spectrum_wavelengths.h"

namespace emulsion {

using SpectrumVariant =
    std::variant<ConstantSpectrum, PiecewiseLinearSpectrum, BlackbodySpectrum, SigmoidSpectrum, RgbIlluminantSpectrum,
                 DenseSpectrum, DaylightSpectrum, LineSpectrum, ProductSpectrum, SumSpectrum>;

/// Any of them. A type of its own, and not the variant's name, so that products and sums can hold spectra.
struct Spectrum : SpectrumVariant {
    using SpectrumVariant::SpectrumVariant;
};

/// One of the alternatives.
template <class T>
concept SpectrumAlternative = !std::same_as<T, Spectrum> && std::constructible_from<Spectrum, T>;

/// The values at base_nm + offset_nm[i]; as many values as wavelengths.
void eval(const Spectrum& spectrum, const OffsetWavelengths& at, std::span<double> values) noexcept;

/// The value at one wavelength, nm > 0. At a knot with a jump (the ends of a table that is 0 outside) the knot's value.
[[nodiscard]] double eval(const Spectrum& spectrum, double lambda_nm) noexcept;
template <SpectrumAlternative T>
[[nodiscard]] double eval(const T& spectrum, double lambda_nm) noexcept {
    double value = 0.0;
    const double offset_nm = 0.0;
    eval(spectrum, OffsetWavelengths{lambda_nm, {&offset_nm, 1}}, {&value, 1});
    return value;
}

/// The values at many wavelengths, nm > 0, the same as one by one; fastest in increasing order.
/// \throws std::invalid_argument unless there are as many values as wavelengths.
void eval(const Spectrum& spectrum, std::span<const double> lambda_nm, std::span<double> values);

/// The value that the spectrum tends to at lambda_nm from one side. Differs from eval only at the ends of a table that
/// is 0 outside, from outside: there it is 0.
[[nodiscard]] double limit(const Spectrum& spectrum, double lambda_nm, Side side) noexcept;

/// The wavelengths at which the spectrum has a kink or a jump, and enough of them around every Gaussian line that it
/// isn't missed; strictly increasing. In between it is smooth.
[[nodiscard]] std::vector<double> knots_nm(const Spectrum& spectrum);

/// Between neighbouring knots the spectrum is a polynomial of at most this degree; unset if it is none.
[[nodiscard]] std::optional<int> polynomial_degree(const Spectrum& spectrum) noexcept;

/// The lines without width, by increasing wavelength, one at a wavelength: lines that meet in a sum are added up, and
/// a product scales each line by the other factors' continua (by eval, so at a jump by the knot's value). For a
/// validated spectrum.
[[nodiscard]] std::vector<Line> delta_lines(const Spectrum& spectrum);

/// scale * a * b, weight_a * a + weight_b * b and scale * a, as values.
[[nodiscard]] Spectrum product_of(Spectrum a, Spectrum b, double scale = 1.0);
[[nodiscard]] Spectrum sum_of(Spectrum a, Spectrum b, double weight_a = 1.0, double weight_b = 1.0);
[[nodiscard]] Spectrum scaled(Spectrum spectrum, double scale);

/// \throws std::invalid_argument naming the field, its value and its range.
void validate(const Spectrum& spectrum);

}  // namespace emulsion
