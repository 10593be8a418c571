#include "display/noise_dither.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "dither_fixture.h"
#include "power_spectrum.h"

namespace emulsion {
namespace {

constexpr int kSide = 256;
constexpr CodeScale kScale{0, 255};

/// Error of every pixel of a constant, in codes.
std::vector<double> errors_of(const Dither& dither, float value) {
    const Image<std::uint16_t> codes = quantize(dither, constant_grey(kSide, kSide, value).view(), kScale, 1);
    std::vector<double> errors;
    for (const int c : codes.pixels()) errors.push_back(c - 255.0 * static_cast<double>(value));
    return errors;
}

double variance(const std::vector<double>& errors) {
    double sum = 0.0, squares = 0.0;
    for (const double e : errors) sum += e, squares += e * e;
    const auto count = static_cast<double>(errors.size());
    return squares / count - sum * sum / (count * count);
}

float between_codes(double codes) { return static_cast<float>(codes / 255.0); }

// The fourth moment of an error is at most about 1, so that the variance of 65,536 is known to 1 / 256; 5 of these.
constexpr double kVarianceTolerance = 0.02;

TEST(WhiteNoise, VarianceGoesWithTheFraction) {
    for (const double fraction : {0.0, 0.1, 0.25, 0.5, 0.7}) {
        EXPECT_NEAR(variance(errors_of(WhiteNoise{}, between_codes(100.0 + fraction))), fraction * (1.0 - fraction),
                    kVarianceTolerance);
    }
}

TEST(TriangularNoise, VarianceIsTheSameAtEveryValue) {
    for (const double value : {0.5, 0.75, 1.0, 100.0, 100.1, 100.25, 100.5, 100.7, 254.0, 254.5}) {
        EXPECT_NEAR(variance(errors_of(TriangularNoise{}, between_codes(value))), 0.25, kVarianceTolerance) << value;
    }
}

TEST(TriangularNoise, AnEighthOfACodeGoesToEachNeighbour) {
    int below = 0, above = 0;
    for (const double e : errors_of(TriangularNoise{}, between_codes(100.0))) {
        below += e < -0.5 ? 1 : 0;
        above += e > 0.5 ? 1 : 0;
    }
    const double deviations = 5.0 * std::sqrt(kSide * kSide * 0.125 * 0.875);
    EXPECT_NEAR(below, kSide * kSide / 8, deviations);
    EXPECT_NEAR(above, kSide * kSide / 8, deviations);
}

// Within half a code of an end it is white noise: no clipping, and so the mean holds.
TEST(TriangularNoise, IsWhiteNoiseNextToTheEnds) {
    for (const double value : {0.0, 0.1, 0.49, 254.51, 254.9, 255.0}) {
        EXPECT_EQ(errors_of(TriangularNoise{}, between_codes(value)), errors_of(WhiteNoise{}, between_codes(value)));
    }
    EXPECT_NE(errors_of(TriangularNoise{}, between_codes(0.51)), errors_of(WhiteNoise{}, between_codes(0.51)));
}

// Pixels, rows and channels must have nothing to do with each other: 5 standard deviations of a correlation.
TEST(WhiteNoise, NeighboursAndChannelsAreIndependent) {
    Image<RGB> picture(kSide, kSide);
    for (RGB& p : picture.pixels()) p = {0.5f, 0.5f, 0.5f};
    const Image<CodeRGB> codes = quantize(WhiteNoise{}, picture.view(), {0, 1}, 1);
    const auto correlation = [&](auto of_one, auto of_other, int dx, int dy) {
        double sum = 0.0;
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                const CodeRGB &one = codes(x, y), &other = codes((x + dx) % kSide, (y + dy) % kSide);
                sum += (2.0 * (one.*of_one) - 1.0) * (2.0 * (other.*of_other) - 1.0);
            }
        }
        return sum / (kSide * kSide);
    };
    for (const auto of_other : {&CodeRGB::r, &CodeRGB::g, &CodeRGB::b}) {
        for (int dy = 0; dy < 3; ++dy) {
            for (int dx = 0; dx < 3; ++dx) {
                if (dx == 0 && dy == 0 && of_other == &CodeRGB::r) continue;
                EXPECT_LT(std::abs(correlation(&CodeRGB::r, of_other, dx, dy)), 5.0 / kSide) << dx << ", " << dy;
            }
        }
    }
    EXPECT_LT(std::abs(correlation(&CodeRGB::g, &CodeRGB::b, 0, 0)), 5.0 / kSide);
}

}  // namespace
}  // namespace emulsion
