// Estimates of infinite variance, as path tracers have of caustics through small lights: what robust estimators buy,
// and what they cost.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "caustic.h"
#include "film/film.h"

namespace emulsion {
namespace {

using stability::caustic_film;
using stability::kCausticMean;

struct Pixels {
    Image<XYZ> picture;
    FilmCounts counts;
    [[nodiscard]] double mean() const {
        double sum = 0.0;
        for (const XYZ& pixel : picture.pixels()) sum += static_cast<double>(pixel.y);
        return sum / static_cast<double>(picture.pixels().size());
    }
    /// The mean distance from the true mean, over it.
    [[nodiscard]] double error() const {
        double sum = 0.0;
        for (const XYZ& pixel : picture.pixels()) sum += std::abs(static_cast<double>(pixel.y) - kCausticMean);
        return sum / static_cast<double>(picture.pixels().size()) / kCausticMean;
    }
    [[nodiscard]] double brightest() const {
        float largest = 0.0f;
        for (const XYZ& pixel : picture.pixels()) largest = std::max(largest, pixel.y);
        return static_cast<double>(largest);
    }
};

Pixels render(const FireflyControl& control, std::uint64_t samples) {
    const auto film = caustic_film(control, samples);
    return {film->xyz_image(), film->counts()};
}

TEST(InfiniteVariance, RobustEstimatorsTradeFirefliesForBias) {
    const Pixels plain = render(NoFireflyControl{}, 256), median = render(MedianOfMeans{5}, 256),
                 clamped = render(LuminanceClamp{100.0f}, 256);
    EXPECT_GT(plain.brightest(), 13.0 * kCausticMean);
    EXPECT_NEAR(plain.mean() / kCausticMean, 0.953, 0.005);
    EXPECT_NEAR(plain.error(), 0.245, 0.005);

    // The median takes the fireflies and a fifth of the light; the mean distance from the truth hardly changes.
    EXPECT_LT(median.brightest(), 3.0 * kCausticMean);
    EXPECT_NEAR(median.mean() / kCausticMean, 0.797, 0.005);
    EXPECT_NEAR(median.error(), 0.225, 0.005);

    EXPECT_LT(clamped.brightest(), 3.0 * kCausticMean);
    EXPECT_NEAR(clamped.mean() / kCausticMean, 0.838, 0.005);
    EXPECT_NEAR(clamped.error(), 0.173, 0.005);

    // E[min(X, c)] = mean - a / (1 - a) c^(1 - 1 / a): what the clamp takes is known, and kept count of.
    const double taken = 3.0 * std::pow(100.0, -1.0 / 3.0);
    EXPECT_NEAR(kCausticMean - clamped.mean(), taken, 0.02);
    const double removed = clamped.counts.clamped.removed_luminance.value() / (256.0 * 32.0 * 32.0);
    EXPECT_NEAR(clamped.mean() + removed, plain.mean(), 1e-4);
}

/// The exponent at which the error falls with the number of samples.
double slope(const FireflyControl& control, std::uint64_t few, std::uint64_t many) {
    return std::log(render(control, many).error() / render(control, few).error()) /
           std::log(static_cast<double>(many) / static_cast<double>(few));
}

/// Without a variance, sums of n converge as n^(a - 1) = n^-1/4 and not as n^-1/2: four times the samples for 0.7 of
/// the error.
void expect_slow_convergence(std::uint64_t few, std::uint64_t many) {
    EXPECT_NEAR(slope(NoFireflyControl{}, few, many), -0.25, 0.08);
    EXPECT_NEAR(slope(MedianOfMeans{5}, few, many), -0.25, 0.08);
}

struct Effort {
    std::uint64_t few, many;
};
class InfiniteVarianceSlope : public testing::TestWithParam<Effort> {};
TEST_P(InfiniteVarianceSlope, IsThatOfTheFourthRoot) { expect_slow_convergence(GetParam().few, GetParam().many); }
INSTANTIATE_TEST_SUITE_P(Short, InfiniteVarianceSlope, testing::Values(Effort{16, 1024}));
INSTANTIATE_TEST_SUITE_P(Long, InfiniteVarianceSlope, testing::Values(Effort{64, 65536}));

}  // namespace
}  // namespace emulsion
