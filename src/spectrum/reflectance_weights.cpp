#include "spectrum/reflectance_weights.h"

#include <cmath>
#include <numeric>
#include <stdexcept>

#include "spectrum/data_table.h"
#include "spectrum/daylight.h"
#include "spectrum/observer.h"

namespace emulsion {

ReflectanceWeights reflectance_weights(const Spectrum& illuminant) {
    const Observer& observer = cie_1931_2deg();
    const std::array<double XYZd::*, 3> functions = {&XYZd::x, &XYZd::y, &XYZd::z};
    ReflectanceWeights weights;
    for (std::size_t i = 0; i < 3; ++i) {
        std::vector<double>& weight = weights.sum[i];
        weight.assign(kWholeNanometres, 0.0);
        const auto product = [&](double lambda_nm) {
            return eval(illuminant, lambda_nm) * eval(observer, lambda_nm).*functions[i];
        };
        // Each cell's integral of product times falling and rising line, by Simpson's rule: exact for straight lines.
        for (std::size_t cell = 0; cell + 1 < weight.size(); ++cell) {
            const double start_nm = kMinWavelength_nm + static_cast<double>(cell);
            const double middle = product(start_nm + 0.5);
            weight[cell] += (product(start_nm) + 2.0 * middle) / 6.0;
            weight[cell + 1] += (2.0 * middle + product(start_nm + 1.0)) / 6.0;
        }
        const double sum = std::accumulate(weight.begin(), weight.end(), 0.0);
        if (!(sum > 0.0)) throw std::invalid_argument("illuminant: 0 in the visible, expected light");
        for (double& w : weight) w /= sum;
    }
    return weights;
}

std::array<double, 3> weighted_sums(const ReflectanceWeights& weights, const Spectrum& reflectance) noexcept {
    std::array<double, 3> sums{};
    for (std::size_t i = 0; i < kWholeNanometres; ++i) {
        const double value = eval(reflectance, kMinWavelength_nm + static_cast<double>(i));
        for (std::size_t j = 0; j < 3; ++j) sums[j] += value * weights.sum[j][i];
    }
    return sums;
}

PiecewiseLinearSpectrum illuminant_of(const RgbSpace& space) {
    constexpr Chromaticity kD65 = {0.3127, 0.3290};
    constexpr double kTolerance = 5e-4;
    if (std::abs(space.white.x - kD65.x) <= kTolerance && std::abs(space.white.y - kD65.y) <= kTolerance) {
        return tabulated_spectrum("illuminants_a_d_300_830_5nm", "D65");
    }
    return daylight(space.white);
}

ReflectanceRgb reflectance_rgb(const RgbSpace& space) {
    ReflectanceRgb result;
    result.space = space;
    result.illuminant = illuminant_of(space);
    result.xyz_weights = reflectance_weights(result.illuminant);

    // Divided by the white, which takes in the small difference between its tabulated chromaticity and its spectrum.
    result.relative_xyz_from_rgb = xyz_from_rgb(space);
    for (auto& row : result.relative_xyz_from_rgb.m) {
        const double white = row[0] + row[1] + row[2];
        for (double& element : row) element /= white;
    }

    const Matrix3 rgb_from_relative_xyz = inverse(result.relative_xyz_from_rgb);
    for (auto& sum : result.rgb_weights.sum) sum.resize(kWholeNanometres);
    for (std::size_t i = 0; i < kWholeNanometres; ++i) {
        const auto& xyz = result.xyz_weights.sum;
        const std::array<double, 3> rgb = rgb_from_relative_xyz * std::array{xyz[0][i], xyz[1][i], xyz[2][i]};
        for (std::size_t j = 0; j < 3; ++j) result.rgb_weights.sum[j][i] = rgb[j];
    }
    return result;
}

}  // namespace emulsion
