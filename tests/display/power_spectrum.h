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

/// The power of every frequency of a square picture; 0 for that of its mean.
template <class T>
Image<double> power_spectrum(const Image<T>& picture) {
    Image<std::complex<double>> values(picture.width(), picture.width());
    for (std::size_t i = 0; i < values.pixels().size(); ++i) {
        values.pixels()[i] = static_cast<double>(picture.pixels()[i]);
    }
    const Image<std::complex<double>> spectrum = transform_rows(transform_rows(values));
    Image<double> power(picture.width(), picture.width());
    for (std::size_t i = 0; i < power.pixels().size(); ++i) power.pixels()[i] = std::norm(spectrum.pixels()[i]);
    power(0, 0) = 0.0;
    return power;
}

/// Of the power of all frequencies but 0, the share of those below `cut`, in cycles a pixel, in whatever direction;
/// Nyquist's frequency is 1/2.
template <class T>
double low_frequency_share(const Image<T>& picture, double cut) {
    const Image<double> power = power_spectrum(picture);
    const int size = power.width();
    double low = 0.0, all = 0.0;
    for (int v = 0; v < size; ++v) {
        for (int u = 0; u < size; ++u) {
            all += power(u, v);
            if (std::hypot(std::min(u, size - u), std::min(v, size - v)) < cut * size) low += power(u, v);
        }
    }
    return low / all;
}

/// The share of the strongest frequency: large where there is a regular texture.
template <class T>
double peak_share(const Image<T>& picture) {
    const Image<double> power = power_spectrum(picture);
    double peak = 0.0, all = 0.0;
    for (const double p : power.pixels()) peak = std::max(peak, p), all += p;
    return peak / all;
}

}  // namespace emulsion
