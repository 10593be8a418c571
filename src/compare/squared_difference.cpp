#include "compare/squared_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "compare/finite_pixel.h"
#include "core/row_blocks.h"
#include "spectrum/rgb_space.h"

namespace emulsion {

namespace {

using Components = std::array<double, 3>;

struct Sums {
    std::int64_t pixels = 0, known_pixels = 0;
    double squared = 0.0, relative = 0.0;
    double known_squared = 0.0, noise = 0.0;  // over the pixels whose noise is known
    double bias = 0.0, squared_bias = 0.0;    // of each of these: its squared difference without its noise
    Sums& operator+=(const Sums& other) noexcept {
        pixels += other.pixels;
        known_pixels += other.known_pixels;
        squared += other.squared;
        relative += other.relative;
        known_squared += other.known_squared;
        noise += other.noise;
        bias += other.bias;
        squared_bias += other.squared_bias;
        return *this;
    }
};

double square(double x) noexcept { return x * x; }

class PixelSums {
  public:
    PixelSums(const ComparedPicture& a, const ComparedPicture& b, const ViewingConditions& viewing)
        : noise_(std::min(a.noise, b.noise)),
          rgb_from_xyz_(rgb_from_xyz(rgb_space("Rec709"))),
          unit_(viewing.white_luminance_cdm2),
          white_({viewing.white.x, viewing.white.y, viewing.white.z}) {}

    void add(const XYZ& a, const XYZ& b, Sums& sums) const noexcept {
        const Components first = relative_xyz(a), second = relative_xyz(b);
        const Components rgb = rgb_from_xyz_ * first, other_rgb = rgb_from_xyz_ * second;
        ++sums.pixels;
        for (std::size_t k = 0; k < 3; ++k) {
            sums.squared += square((second[k] - first[k]) / white_[k]) / 3.0;
            sums.relative += square(other_rgb[k] - rgb[k]) / (square(rgb[k]) + kRelativeErrorOffset) / 3.0;
        }
    }

    void add_noise(const XYZ& a, const XYZ& b, const XYZ& error_a, const XYZ& error_b, const XYZd& around,
                   Sums& sums) const noexcept {
        const Components first = relative_xyz(a), second = relative_xyz(b), mean = relative_xyz(around);
        const Components noise_a = relative_xyz(error_a), noise_b = relative_xyz(error_b);
        const std::size_t begin = noise_ == KnownNoise::luminance ? 1 : 0,
                          end = noise_ == KnownNoise::luminance ? 2 : 3;
        double squared = 0.0, noise = 0.0;
        for (std::size_t k = begin; k < end; ++k) {
            const double weight = 1.0 / (square(mean[k] / white_[k]) + kRelativeErrorOffset);
            squared += weight * square((second[k] - first[k]) / white_[k]);
            noise += weight * (square(noise_a[k] / white_[k]) + square(noise_b[k] / white_[k]));
        }
        squared /= static_cast<double>(end - begin);
        noise /= static_cast<double>(end - begin);
        if (!std::isfinite(noise)) return;
        ++sums.known_pixels;
        sums.known_squared += squared;
        sums.noise += noise;
        sums.bias += squared - noise;
        sums.squared_bias += square(squared - noise);
    }

    /// What both know.
    [[nodiscard]] KnownNoise noise() const noexcept { return noise_; }

  private:
    template <class T>
    [[nodiscard]] Components relative_xyz(const BasicXYZ<T>& xyz) const noexcept {
        return {xyz.x / unit_, xyz.y / unit_, xyz.z / unit_};
    }

    KnownNoise noise_;
    Matrix3 rgb_from_xyz_;
    double unit_;
    Components white_;
};

/// The mean of both over the finite pixels around (x, y), that one left out; 0 if there are none.
XYZd mean_around(const ComparedPicture& a, const ComparedPicture& b, int x, int y) noexcept {
    XYZd sum;
    int count = 0;
    const int right = std::min(x + 1, a.xyz.width() - 1), below = std::min(y + 1, a.xyz.height() - 1);
    for (int v = std::max(0, y - 1); v <= below; ++v) {
        for (int u = std::max(0, x - 1); u <= right; ++u) {
            if (u == x && v == y) continue;
            for (const XYZ& pixel : {a.xyz(u, v), b.xyz(u, v)}) {
                if (!is_finite(pixel)) continue;
                sum = sum + XYZd{pixel.x, pixel.y, pixel.z};
                ++count;
            }
        }
    }
    return count == 0 ? sum : (1.0 / count) * sum;
}

std::optional<NoiseAndBias> noise_and_bias(const Sums& sums, KnownNoise components) noexcept {
    if (sums.known_pixels == 0) return std::nullopt;
    const auto n = static_cast<double>(sums.known_pixels);
    const double mean = sums.bias / n, variance = std::max(0.0, sums.squared_bias / n - mean * mean);
    return NoiseAndBias{.components = components,
                        .pixels = sums.known_pixels,
                        .mean_squared = sums.known_squared / n,
                        .noise = sums.noise / n,
                        .bias = (sums.known_squared - sums.noise) / n,
                        .bias_standard_error = std::sqrt(variance / n)};
}

}  // namespace

SquaredDifference squared_difference(const ComparedPicture& a, const ComparedPicture& b,
                                     const ViewingConditions& viewing, int threads) {
    const PixelSums pixel_sums(a, b, viewing);
    std::vector<Sums> rows(static_cast<std::size_t>(a.xyz.height()));
    parallel_for_rows(a.xyz.width(), a.xyz.height(), threads, [&](int y) {
        Sums sums;
        for (int x = 0; x < a.xyz.width(); ++x) {
            const XYZ& pixel_a = a.xyz(x, y);
            const XYZ& pixel_b = b.xyz(x, y);
            if (!is_finite(pixel_a) || !is_finite(pixel_b)) continue;
            pixel_sums.add(pixel_a, pixel_b, sums);
            if (pixel_sums.noise() == KnownNoise::none) continue;
            pixel_sums.add_noise(pixel_a, pixel_b, a.standard_error(x, y), b.standard_error(x, y),
                                 mean_around(a, b, x, y), sums);
        }
        rows[static_cast<std::size_t>(y)] = sums;
    });
    Sums total;
    for (const Sums& sums : rows) total += sums;

    SquaredDifference result{.pixels = total.pixels, .parts = noise_and_bias(total, pixel_sums.noise())};
    if (total.pixels == 0) return result;
    const auto n = static_cast<double>(total.pixels);
    result.mean_squared = total.squared / n;
    result.relative = total.relative / n;
    return result;
}

}  // namespace emulsion
