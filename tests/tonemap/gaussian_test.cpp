// Gaussian kernels, blurs by them, and pictures of half the size.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "tonemap/axis_halving.h"
#include "tonemap/gaussian_blur.h"
#include "tonemap/gaussian_kernel.h"
#include "tonemap/gaussian_rows.h"
#include "tonemap/half_size.h"
#include "tonemap/mirrored_border.h"
#include "tonemap/neighbourhood_rows.h"

namespace emulsion {
namespace {

template <class T>
Image<T> noise(int width, int height, unsigned seed) {
    Pcg32 random(seed);
    Image<T> image(width, height);
    for (T& value : image.pixels()) value = static_cast<T>(random.next_float());
    return image;
}

/// Largest |fast - exact|.
double largest_error(const Image<float>& fast, const Image<double>& exact) {
    double largest = 0.0;
    for (std::size_t i = 0; i < fast.pixels().size(); ++i) {
        largest = std::max(largest, std::abs(fast.pixels()[i] - exact.pixels()[i]));
    }
    return largest;
}

TEST(MirroredBorder, RepeatsTheOuterPixelAndGoesBack) {
    const std::vector<int> expected = {1, 2, 2, 1, 0, 0, 1, 2, 2, 1, 0, 0, 1, 2};
    for (int i = -5; i < 9; ++i) EXPECT_EQ(mirrored(i, 3), expected[static_cast<std::size_t>(i + 5)]) << i;
    for (int i = -5; i < 5; ++i) EXPECT_EQ(mirrored(i, 1), 0) << i;
}

// By hand: the middle has erf(0.5 / (0.25 sqrt 2)) = 0.954500, the two-sigma share of a normal distribution.
TEST(GaussianKernel, IsIntegratedOverPixels) {
    const std::vector<double> kernel = gaussian_kernel(0.25, 1e-9);
    EXPECT_NEAR(kernel[0], 0.954500, 1e-6);
    EXPECT_NEAR(kernel[1], 0.022750, 1e-6);
    EXPECT_EQ(gaussian_kernel(0.0, 1e-9), std::vector<double>{1.0});
}

TEST(GaussianKernel, SumsToOneAndHasItsVariance) {
    for (const double sigma : {0.1, 0.25, 0.5, 1.0, 3.3, 20.0}) {
        const std::vector<double> kernel = gaussian_kernel(sigma, 1e-12);
        double sum = kernel[0], variance = 0.0;
        for (std::size_t i = 1; i < kernel.size(); ++i) {
            sum += 2.0 * kernel[i];
            variance += 2.0 * static_cast<double>(i * i) * kernel[i];
        }
        EXPECT_NEAR(sum, 1.0, 1e-14) << sigma;
        if (sigma < 0.5) continue;
        EXPECT_NEAR(variance / (sigma * sigma + 1.0 / 12.0), 1.0, sigma < 1.0 ? 0.05 : 1e-6) << sigma;
    }
}

// Blocks of many sums at a time, in wide registers, and what is left over, each sum alone.
TEST(Convolve, GivesTheBitsOfOneSumAtATime) {
    const Image<float> rows = noise<float>(100, 7, 6);
    std::vector<const float*> taps;
    for (int y = 0; y < 7; ++y) taps.push_back(rows.row(y).data());
    const std::vector<float> kernel = {0.4f, 0.2f, 0.07f, 0.03f};
    for (const std::size_t count : {1u, 31u, 32u, 33u, 100u}) {
        std::vector<float> sums(count);
        convolve(kernel, taps, sums);
        for (std::size_t i = 0; i < count; ++i) {
            float sum = kernel[0] * taps[3][i];
            for (std::size_t j = 1; j <= 3; ++j) sum += kernel[j] * (taps[3 - j][i] + taps[3 + j][i]);
            EXPECT_EQ(sums[i], sum) << i << " of " << count;
        }
    }
}

// Truncation leaves 1e-4 of the weight out, of values in [0, 1].
TEST(GaussianRows, AgreesWithItsTwin) {
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 67}, {67, 1}, {3, 5}, {131, 37}, {640, 8}}) {
        const Image<float> picture = noise<float>(width, height, 1);
        const std::array sigmas = {0.0, 0.25, 0.7, 2.0, 9.0};
        std::vector<GaussianSigma> both;
        for (const double sigma : sigmas) both.push_back({sigma, sigma});
        GaussianRows rows(width, both, 1e-4);
        for (std::size_t i = 0; i < sigmas.size(); ++i) {
            Image<float> blurred(width, height);
            for (int y = height; y-- > 0;) {
                std::vector<const float*> about;
                for (int j = -rows.radius(); j <= rows.radius(); ++j) {
                    about.push_back(picture.row(mirrored(y + j, picture.height())).data());
                }
                rows.compute(about);
                std::copy(rows.row(i).begin(), rows.row(i).end(), blurred.row(y).begin());
            }
            const Image<double> exact = gaussian_blur_reference(noise<double>(width, height, 1), sigmas[i]);
            EXPECT_LE(largest_error(blurred, exact), 2e-4) << width << "x" << height << ", sigma " << sigmas[i];
        }
    }
}

TEST(GaussianRows, MeanOfThePictureStays) {
    const Image<double> picture = noise<double>(41, 23, 2), blurred = gaussian_blur_reference(picture, 7.0);
    double before = 0.0, after = 0.0;
    for (const double value : picture.pixels()) before += value;
    for (const double value : blurred.pixels()) after += value;
    EXPECT_NEAR(after, before, 1e-10);
}

// Of 0.5 and noise in [0, 1] the blur at sigma has a standard deviation of 0.29 / (2 sqrt(pi) sigma); what decimation
// folds back is far below that. Odd sizes differ by where the half ends.
TEST(GaussianBlur, AgreesWithItsTwin) {
    for (const double sigma : {0.3, 2.0, 3.0, 8.0, 40.0}) {
        for (const auto& [width, height] : {std::pair{256, 128}, {128, 64}}) {
            const Image<float> blurred = gaussian_blur(noise<float>(width, height, 3), sigma, 0);
            const Image<double> exact = gaussian_blur_reference(noise<double>(width, height, 3), sigma);
            EXPECT_LE(largest_error(blurred, exact), 0.004) << width << "x" << height << ", sigma " << sigma;
        }
    }
}

TEST(GaussianBlur, OddSizesAndLinesAgreeNearly) {
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 499}, {499, 1}, {127, 131}, {5, 300}}) {
        for (const double sigma : {3.0, 20.0}) {
            const Image<float> blurred = gaussian_blur(noise<float>(width, height, 4), sigma, 0);
            const Image<double> exact = gaussian_blur_reference(noise<double>(width, height, 4), sigma);
            EXPECT_LE(largest_error(blurred, exact), 0.05) << width << "x" << height << ", sigma " << sigma;
        }
    }
}

TEST(GaussianBlur, SameBitsForEveryNumberOfThreads) {
    const Image<float> picture = noise<float>(301, 203, 5), one = gaussian_blur(picture, 12.0, 1);
    for (const int threads : {2, 3, 0}) EXPECT_EQ(gaussian_blur(picture, 12.0, threads), one);
}

/// At half the size and back at the whole.
Image<float> there_and_back(const Image<float>& picture) {
    const AxisHalving x(picture.width()), y(picture.height());
    const Image<float> half = half_size(picture, x, y, 1);
    EXPECT_EQ(half.width(), (picture.width() + 1) / 2);
    EXPECT_EQ(half.height(), (picture.height() + 1) / 2);
    std::vector<float> scratch(static_cast<std::size_t>(half.width()) + 2);
    Image<float> back(picture.width(), picture.height());
    for (int row = 0; row < back.height(); ++row) double_size_row(half, x, y, row, scratch, back.row(row));
    return back;
}

TEST(HalfSize, ConstantStaysConstantAndComesBack) {
    for (const auto& [width, height] : {std::pair{1, 1}, {2, 3}, {7, 4}, {64, 32}}) {
        Image<float> picture(width, height);
        std::fill(picture.pixels().begin(), picture.pixels().end(), 3.0f);
        const Image<float> back = there_and_back(picture);
        for (const float value : back.pixels()) EXPECT_NEAR(value, 3.0f, 1e-6f);
    }
}

// A ramp, away from the edges: both steps are linear and have no shift.
TEST(HalfSize, RampComesBackAsItWas) {
    Image<float> ramp(32, 32);
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 32; ++x) ramp(x, y) = static_cast<float>(x + 100 * y);
    }
    const Image<float> back = there_and_back(ramp);
    for (int y = 4; y < 28; ++y) {
        for (int x = 4; x < 28; ++x) EXPECT_NEAR(back(x, y), ramp(x, y), 1e-3f) << x << ", " << y;
    }
}

// A picture of odd size, mirrored: but for rounding the same mirrored.
TEST(HalfSize, MirrorsWithAPictureOfOddSize) {
    for (const auto& [width, height] : {std::pair{3, 5}, {37, 51}, {101, 20}}) {
        const Image<float> picture = noise<float>(width, height, 7);
        Image<float> mirror(width, height);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) mirror(width - 1 - x, y) = picture(x, y);
        }
        const Image<float> one = there_and_back(picture), other = there_and_back(mirror);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) EXPECT_NEAR(one(x, y), other(width - 1 - x, y), 1e-6f) << x << ", " << y;
        }
    }
}

}  // namespace
}  // namespace emulsion
