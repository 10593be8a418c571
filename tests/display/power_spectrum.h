#pragma once
// Power spectra of square pictures.

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

#include "core/image.h"

namespace emulsion {

/// The discrete Fourier transform of every row, transposed: done twice, it is that of the picture. Straight from the
/// definition, in double precision.
inline Image<std::complex<double>> transform_rows(const Image<std::complex<double>>& picture) {
    const int size = picture.width();
    std::vector<std::complex<double>> roots;
    for (int k = 0; k < size; ++k) roots.push_back(std::polar(1.0, -2.0 * std::numbers::pi * k / size));
    Image<std::complex<double>> transformed(size, size);
    for (int y = 0; y < size; ++y) {
        for (int u = 0; u < size; ++u) {
            std::complex<double> sum;
            for (int x = 0; x < size; ++x) sum += picture(x, y) * roots[static_cast<std::size_t>(u * x % size)];
            transformed(y, u) = sum;
        }
    }
    return transformed;
}

/// Of the power of all frequencies but 0 of a square picture, the share of those below `cut`, in cycles a pixel, in
/// whatever direction; Nyquist's frequency is 1/2.
template <class T>
double low_frequency_share(const Image<T>& picture, double cut) {
    const int size = picture.width();
    Image<std::complex<double>> values(size, size);
    for (std::size_t i = 0; i < values.pixels().size(); ++i)
        values.pixels()[i] = static_cast<double>(picture.pixels()[i]);
    const Image<std::complex<double>> spectrum = transform_rows(transform_rows(values));
    double low = 0.0, all = 0.0;
    for (int v = 0; v < size; ++v) {
        for (int u = 0; u < size; ++u) {
            if (u == 0 && v == 0) continue;
            const double power = std::norm(spectrum(u, v));
            all += power;
            if (std::hypot(std::min(u, size - u), std::min(v, size - v)) < cut * size) low += power;
        }
    }
    return low / all;
}

}  // namespace emulsion
