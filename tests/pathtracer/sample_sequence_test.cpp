#include "pathtracer/sample_sequence.h"

#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace emulsion {
namespace {

const std::vector<Sampler> kSamplers = {IndependentSampler{64}, StratifiedSampler{8, 8}, StratifiedSampler{8, 8, false},
                                        PaddedSobolSampler{64}};

TEST(SampleSequence, IsAFunctionOfSeedPixelAndIndex) {
    for (const Sampler& sampler : kSamplers) {
        SampleSequence a(sampler, 1, 3, 4, 5), b(sampler, 1, 3, 4, 5);
        for (int i = 0; i < 10; ++i) {
            EXPECT_EQ(a.next_1d(), b.next_1d());
            EXPECT_EQ(a.next_2d(), b.next_2d());
        }
    }
    // Another seed, column, row or index gives other numbers.
    const Sampler sampler = IndependentSampler{};
    std::set<float> firsts;
    for (const auto& [seed, x, y, index] :
         {std::array{1, 3, 4, 5}, {2, 3, 4, 5}, {1, 4, 4, 5}, {1, 3, 5, 5}, {1, 4, 3, 5}, {1, 3, 4, 6}}) {
        firsts.insert(SampleSequence(sampler, static_cast<std::uint64_t>(seed), x, y, index).next_1d());
    }
    EXPECT_EQ(firsts.size(), 6u);
}

/// Mean and second moments of every dimension, within 5 standard errors of those of uniform numbers for independent
/// points; the others do better.
TEST(SampleSequence, NumbersAreUniformInTheUnitInterval) {
    for (const Sampler& sampler : kSamplers) {
        constexpr int kPixels = 400, kSamples = 64, kDimensions = 6;
        std::array<double, 3 * kDimensions> sum{}, sum_of_squares{};
        for (int pixel = 0; pixel < kPixels; ++pixel) {
            for (int i = 0; i < kSamples; ++i) {
                SampleSequence sequence(sampler, 7, pixel, 2 * pixel, i);
                for (std::size_t d = 0; d < kDimensions; ++d) {
                    const float one = sequence.next_1d();
                    const auto [x, y] = sequence.next_2d();
                    const float values[] = {one, x, y};
                    for (std::size_t k = 0; k < 3; ++k) {
                        ASSERT_TRUE(values[k] >= 0.0f && values[k] < 1.0f);
                        sum[3 * d + k] += static_cast<double>(values[k]);
                        sum_of_squares[3 * d + k] += static_cast<double>(values[k] * values[k]);
                    }
                }
            }
        }
        constexpr double kCount = kPixels * kSamples;
        // Cell centres have a variance that is smaller by 1/64 of it, in the worst dimension.
        for (std::size_t k = 0; k < sum.size(); ++k) {
            EXPECT_NEAR(sum[k] / kCount, 0.5, 5.0 * std::sqrt(1.0 / 12.0 / kCount)) << sampler.index() << " " << k;
            EXPECT_NEAR(sum_of_squares[k] / kCount, 1.0 / 3.0, 5.0 * std::sqrt(4.0 / 45.0 / kCount) + 2e-3)
                << sampler.index() << " " << k;
        }
    }
}

/// Dimensions of one sampler must not be correlated, or products would be biased: covariance within 5 standard errors.
TEST(SampleSequence, DimensionsAreIndependentOfEachOther) {
    for (const Sampler& sampler : kSamplers) {
        constexpr int kPixels = 1000, kSamples = 64;
        double covariance = 0.0;
        for (int pixel = 0; pixel < kPixels; ++pixel) {
            for (int i = 0; i < kSamples; ++i) {
                SampleSequence sequence(sampler, 3, pixel, 0, i);
                const auto first = sequence.next_2d(), second = sequence.next_2d();
                covariance += (static_cast<double>(first[0]) - 0.5) * (static_cast<double>(second[0]) - 0.5);
            }
        }
        constexpr double kCount = static_cast<double>(kPixels) * kSamples;
        EXPECT_NEAR(covariance / kCount, 0.0, 5.0 / 12.0 / std::sqrt(kCount)) << sampler.index();
    }
}

TEST(SampleSequence, StratifiedSamplersPutOneSampleIntoEachStratum) {
    for (const Sampler& sampler : {kSamplers[1], kSamplers[2], kSamplers[3]}) {
        for (int dimension = 0; dimension < 4; ++dimension) {
            std::set<std::pair<int, int>> cells;
            for (int i = 0; i < 64; ++i) {
                SampleSequence sequence(sampler, 0, 10, 20, i);
                for (int skip = 0; skip < dimension; ++skip) (void)sequence.next_2d();
                const auto [x, y] = sequence.next_2d();
                cells.emplace(static_cast<int>(8.0f * x), static_cast<int>(8.0f * y));
            }
            EXPECT_EQ(cells.size(), 64u) << sampler.index() << ", dimension " << dimension;
        }
    }
}

TEST(SamplesPerPixel, AreReadAndReplaced) {
    EXPECT_EQ(samples_per_pixel(StratifiedSampler{3, 5}), 15);
    EXPECT_EQ(samples_per_pixel(IndependentSampler{7}), 7);
    for (const Sampler& sampler : kSamplers) {
        for (const int count : {1, 2, 7, 12, 36, 1000}) {
            const Sampler changed = with_samples_per_pixel(sampler, count);
            EXPECT_EQ(samples_per_pixel(changed), count);
            EXPECT_EQ(changed.index(), sampler.index());
        }
    }
    // The scene's own strata stay, if the number does.
    const auto kept = std::get<StratifiedSampler>(with_samples_per_pixel(StratifiedSampler{16, 1, false}, 16));
    EXPECT_EQ(kept.x_samples, 16);
    EXPECT_EQ(kept.y_samples, 1);
    EXPECT_FALSE(kept.jitter);
    EXPECT_EQ(std::get<StratifiedSampler>(with_samples_per_pixel(StratifiedSampler{}, 36)).x_samples, 6);
}

}  // namespace
}  // namespace emulsion
