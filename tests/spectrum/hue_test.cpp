#include "spectrum/hue.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace emulsion {
namespace {

TEST(Hue, RunsFromTheFirstComponentToTheSecond) {
    EXPECT_EQ(chroma_hue_of({2.0, 0.0}), (ChromaHue{2.0, 0.0}));
    EXPECT_EQ(chroma_hue_of({0.0, 2.0}), (ChromaHue{2.0, 90.0}));
    EXPECT_EQ(chroma_hue_of({-2.0, 0.0}), (ChromaHue{2.0, 180.0}));
    EXPECT_EQ(chroma_hue_of({0.0, -2.0}), (ChromaHue{2.0, 270.0}));
    EXPECT_DOUBLE_EQ(chroma_hue_of({3.0, -4.0}).chroma, 5.0);
}

TEST(Hue, OfGreysIsZeroWhateverTheSignsOfTheirZeros) {
    for (const double a : {0.0, -0.0}) {
        for (const double b : {0.0, -0.0}) EXPECT_EQ(chroma_hue_of({a, b}), (ChromaHue{0.0, 0.0}));
    }
}

TEST(Hue, StaysBelow360) {
    // 360 minus so little is rounded to 360.
    EXPECT_EQ(chroma_hue_of({1.0, -1e-300}).hue_deg, 0.0);
    EXPECT_LT(chroma_hue_of({1.0, -1e-15}).hue_deg, 360.0);
}

TEST(Hue, IsPeriodicAndNegativeChromaIsTheOppositeHue) {
    const Chromatic expected = chromatic_of({2.0, 30.0});
    EXPECT_NEAR(expected.first, std::sqrt(3.0), 1e-15);
    EXPECT_NEAR(expected.second, 1.0, 1e-15);
    for (const ChromaHue& same : {ChromaHue{2.0, 390.0}, ChromaHue{2.0, -330.0}, ChromaHue{-2.0, 210.0}}) {
        EXPECT_NEAR(chromatic_of(same).first, expected.first, 1e-14);
        EXPECT_NEAR(chromatic_of(same).second, expected.second, 1e-14);
    }
}

TEST(Hue, KeepsNan) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(chroma_hue_of({kNan, 0.0}).chroma));
    EXPECT_TRUE(std::isnan(chroma_hue_of({0.0, kNan}).hue_deg));
}

}  // namespace
}  // namespace emulsion
