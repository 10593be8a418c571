#include "spectrum/uplift_three_bands.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace emulsion {

namespace {

// Where the edges are looked for: between blue and green, and between green and red.
constexpr int kShortestEdge_nm = 440, kMiddleEdge_nm = 540, kLongestEdge_nm = 680;

// Sums of a weight up to each whole nanometre, that one included.
std::array<std::vector<double>, 3> running_sums(const ReflectanceWeights& weights) {
    std::array<std::vector<double>, 3> sums = weights.sum;
    for (auto& sum : sums) std::partial_sum(sum.begin(), sum.end(), sum.begin());
    return sums;
}

// Columns: linear RGB of the short, middle and long band.
Matrix3 rgb_from_band(const std::array<std::vector<double>, 3>& sums, const std::array<int, 2>& edge_nm) noexcept {
    Matrix3 matrix;
    for (std::size_t row = 0; row < 3; ++row) {
        const double to_first = sums[row][static_cast<std::size_t>(edge_nm[0] - kMinWavelength_nm)];
        const double to_second = sums[row][static_cast<std::size_t>(edge_nm[1] - kMinWavelength_nm)];
        matrix.m[row] = {to_first, to_second - to_first, sums[row].back() - to_second};
    }
    return matrix;
}

// The farthest a band's value gets from [0, 1]. The rows add up to 1, so that it goes as far above as below.
double farthest_outside(const Matrix3& band_from_rgb) noexcept {
    double farthest = 0.0;
    for (const auto& row : band_from_rgb.m) {
        double below = 0.0;
        for (const double element : row) below -= std::min(element, 0.0);
        farthest = std::max(farthest, below);
    }
    return farthest;
}

}  // namespace

ThreeBands::ThreeBands(const ReflectanceRgb& space) {
    const auto sums = running_sums(space.rgb_weights);
    double least = std::numeric_limits<double>::infinity();
    for (int first_nm = kShortestEdge_nm; first_nm < kMiddleEdge_nm; ++first_nm) {
        for (int second_nm = kMiddleEdge_nm; second_nm <= kLongestEdge_nm; ++second_nm) {
            const Matrix3 band_from_rgb = inverse(rgb_from_band(sums, {first_nm, second_nm}));
            const double outside = farthest_outside(band_from_rgb);
            if (outside >= least) continue;
            least = outside;
            edge_nm_ = {first_nm, second_nm};
            band_from_rgb_ = band_from_rgb;
        }
    }
}

std::array<double, 3> ThreeBands::unclipped(const RGBd& rgb) const noexcept {
    if (rgb.r == rgb.g && rgb.g == rgb.b) return {rgb.r, rgb.r, rgb.r};
    return band_from_rgb_ * std::array<double, 3>{rgb.r, rgb.g, rgb.b};
}

PiecewiseLinearSpectrum ThreeBands::reflectance(const RGBd& rgb) const {
    std::array<double, 3> band = unclipped(rgb);
    for (double& value : band) value = std::clamp(value, 0.0, 1.0);
    const double first_nm = edge_nm_[0], second_nm = edge_nm_[1];
    return {{kMinWavelength_nm, first_nm, first_nm + 1.0, second_nm, second_nm + 1.0, kMaxWavelength_nm},
            {band[0], band[0], band[1], band[1], band[2], band[2]},
            Extrapolation::hold};
}

}  // namespace emulsion
