#include "chart/visual_filter.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

namespace emulsion {

void fourier_transform(std::span<std::complex<double>> values) noexcept {
    const std::size_t count = values.size();
    for (std::size_t i = 1, reversed = 0; i < count; ++i) {
        std::size_t bit = count >> 1;
        for (; (reversed & bit) != 0; bit >>= 1) reversed ^= bit;
        reversed |= bit;
        if (i < reversed) std::swap(values[i], values[reversed]);
    }
    for (std::size_t length = 2; length <= count; length *= 2) {
        const double angle = -2.0 * std::numbers::pi / static_cast<double>(length);
        for (std::size_t start = 0; start < count; start += length) {
            for (std::size_t k = 0; k < length / 2; ++k) {
                const std::complex<double> turn = std::polar(1.0, angle * static_cast<double>(k));
                const std::complex<double> even = values[start + k], odd = turn * values[start + k + length / 2];
                values[start + k] = even + odd;
                values[start + k + length / 2] = even - odd;
            }
        }
    }
}

double contrast_sensitivity(double cycles_per_degree) noexcept {
    const auto formula = [](double f) { return 2.6 * (0.0192 + 0.114 * f) * std::exp(-std::pow(0.114 * f, 1.1)); };
    // Where the derivative of the formula is 0.
    constexpr double kPeak = 7.8909;
    return cycles_per_degree <= kPeak ? 1.0 : formula(cycles_per_degree) / formula(kPeak);
}

double visible_rms(const Image<double>& error, double pixels_per_degree) {
    const auto side = static_cast<std::size_t>(error.width());
    if (error.width() != error.height() || !std::has_single_bit(side)) {
        throw std::invalid_argument("visible error: expected a square with a power of 2 pixels on a side");
    }
    std::vector<std::complex<double>> rows(error.pixels().begin(), error.pixels().end()), column(side);
    for (std::size_t y = 0; y < side; ++y) fourier_transform(std::span(rows).subspan(y * side, side));
    // Parseval: the sum of squares is that of the spectrum over the number of pixels.
    double sum = 0.0;
    const auto cycles = [&](std::size_t i) {
        const auto n = static_cast<double>(i <= side / 2 ? i : side - i);
        return n / static_cast<double>(side) * pixels_per_degree;
    };
    for (std::size_t x = 0; x < side; ++x) {
        for (std::size_t y = 0; y < side; ++y) column[y] = rows[y * side + x];
        fourier_transform(column);
        for (std::size_t y = 0; y < side; ++y) {
            const double seen = contrast_sensitivity(std::hypot(cycles(x), cycles(y)));
            sum += seen * seen * std::norm(column[y]);
        }
    }
    const auto pixels = static_cast<double>(side * side);
    return std::sqrt(sum) / pixels;
}

}  // namespace emulsion
