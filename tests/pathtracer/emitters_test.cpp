#include "pathtracer/emitters.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pathtracer/sample_sequence.h"

namespace emulsion::testing {
namespace {

TEST(EmitterPicker, PicksInProportion) {
    const std::vector<double> weights = {1.0, 0.0, 5.0, 2.5, 1e-3, 10.0, 3.0};
    const EmitterPicker picker(weights);
    constexpr int kCount = 1 << 20;
    std::vector<double> picked(weights.size());
    for (int i = 0; i < kCount; ++i) ++picked[picker.pick((i + 0.5) / kCount)];
    double total = 0.0;
    for (const double weight : weights) total += weight;
    // Evenly spread numbers: each cell of the table is off by at most two of them.
    for (std::size_t i = 0; i < weights.size(); ++i) {
        EXPECT_NEAR(picked[i] / kCount, weights[i] / total, 2.0 * static_cast<double>(weights.size()) / kCount) << i;
    }
    EXPECT_EQ(picked[1], 0.0);
}

/// Among 100,001 emitters, one of which has a third of the weight: with the 24 bits of a float it would get 0.7% less.
TEST(EmitterPicker, PicksInProportionAmongMany) {
    std::vector<double> weights(100001, 1.0);
    weights[777] = 50000.0;
    const EmitterPicker picker(weights);
    constexpr int kCount = 1 << 22;
    int picked = 0;
    for (int i = 0; i < kCount; ++i) {
        SampleSequence sequence(IndependentSampler{}, 1, 0, 0, i);
        picked += picker.pick(sequence.next_1d_fine()) == 777 ? 1 : 0;
    }
    const double expected = 50000.0 / 150000.0, error = std::sqrt(expected * (1.0 - expected) / kCount);
    EXPECT_NEAR(static_cast<double>(picked) / kCount, expected, 4.5 * error);  // 0.3%; by chance 7e-6
}

}  // namespace
}  // namespace emulsion::testing
