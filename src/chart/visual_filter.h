#pragma once
// What an eye at some distance still sees of the error of a picture.

#include <complex>
#include <span>

#include "core/image.h"

namespace emulsion {

/// Fourier transform of `values` in place, not normalised; there must be a power of 2 of them.
void fourier_transform(std::span<std::complex<double>> values) noexcept;

/// Contrast sensitivity, relative to its peak, at a spatial frequency in cycles per degree, and 1 below the peak: an
/// error of the mean is seen. Source: J. L. Mannos & D. J. Sakrison, "The Effects of a Visual Fidelity Criterion on the
/// Encoding of Images", IEEE Trans. Information Theory 20 (1974), eq. 26; made low-pass as by J. Sullivan, R. Miller &
/// G. Pios, "Image halftoning using a visual model in error diffusion", J. Opt. Soc. Am. A 10 (1993).
[[nodiscard]] double contrast_sensitivity(double cycles_per_degree) noexcept;

/// Root of the mean square of an error picture behind that filter. The picture repeats itself at its borders.
/// \param pixels_per_degree of the eye's field; > 0
/// \throws std::invalid_argument unless the picture is a square with a power of 2 pixels on a side.
[[nodiscard]] double visible_rms(const Image<double>& error, double pixels_per_degree);

}  // namespace emulsion
