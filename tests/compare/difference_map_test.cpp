// The false colours of maps of differences, and the maps.

#include "compare/difference_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "compare/difference_ramp.h"
#include "spectrum/ciede2000_difference.h"
#include "spectrum/color_context.h"

namespace emulsion {
namespace {

Lab lab_of(const RGBd& encoded) {
    const ColorContext srgb;
    return lab_from_xyz(srgb.xyz_from_encoded(encoded), srgb.white());
}

TEST(DifferenceRamp, EqualStepsLookEqual) {
    const DifferenceRamp ramp;
    constexpr int kSteps = 64;
    std::vector<double> steps;
    for (int i = 0; i < kSteps; ++i) {
        const double from = static_cast<double>(i) / kSteps, to = static_cast<double>(i + 1) / kSteps;
        steps.push_back(difference(Ciede2000Difference{}, lab_of(ramp.encoded(from)), lab_of(ramp.encoded(to))));
    }
    const auto [least, most] = std::ranges::minmax(steps);
    EXPECT_LT(most / least, 1.05);  // chords of a bent curve, over its arcs
    EXPECT_GT(least, 1.0);
}

TEST(DifferenceRamp, GetsLighterThroughoutAndStaysInsideSrgb) {
    const DifferenceRamp ramp;
    double lightness = -1.0;
    for (int i = 0; i <= 256; ++i) {
        const RGBd color = ramp.encoded(i / 256.0);
        EXPECT_GE(std::min({color.r, color.g, color.b}), 0.0) << i;
        EXPECT_LE(std::max({color.r, color.g, color.b}), 1.0) << i;
        EXPECT_GT(lab_of(color).l, lightness) << i;
        lightness = lab_of(color).l;
    }
    EXPECT_EQ(ramp.code(0.0), (CodeRGB{0, 0, 0}));
    EXPECT_EQ(ramp.code(-1.0), ramp.code(0.0));
    EXPECT_EQ(ramp.code(7.0), ramp.code(1.0));
    EXPECT_GT(lightness, 94.0);
}

DifferenceStatistics with_p99(double p99) { return {.pixels = 1, .p99 = p99}; }

TEST(DifferenceMap, ScalesEndWithRoundNumbers) {
    EXPECT_EQ(scale_end(with_p99(0.0)), 1.0);
    EXPECT_EQ(scale_end(with_p99(1.0)), 1.0);
    EXPECT_EQ(scale_end(with_p99(1.001)), 2.0);
    EXPECT_EQ(scale_end(with_p99(2.5)), 3.0);
    EXPECT_EQ(scale_end(with_p99(4.0)), 5.0);
    EXPECT_EQ(scale_end(with_p99(73.0)), 100.0);
    EXPECT_EQ(scale_end(with_p99(120.0)), 200.0);
}

TEST(DifferenceMap, PixelsHaveTheColoursOfTheRampAboveTheScale) {
    Image<double> differences(40, 30);
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) differences(x, y) = 0.1 * x;
    }
    differences(7, 5) = std::numeric_limits<double>::quiet_NaN();
    const DifferenceStatistics statistics = difference_statistics(std::as_const(differences).view());
    const DifferenceRamp ramp;
    for (const double end : {2.0, 5.0}) {
        const Image<CodeRGB> map = difference_map(differences, statistics, {.end = end});
        EXPECT_GT(map.width(), 150);  // room for a scale that can be read
        EXPECT_GT(map.height(), 30 + 40);
        EXPECT_EQ(map(0, 0), ramp.code(0.0));
        EXPECT_EQ(map(10, 29), ramp.code(1.0 / end));
        EXPECT_EQ(map(39, 12), ramp.code(3.9 / end));
        EXPECT_EQ(map(7, 5).r, 128);
        EXPECT_EQ(map(7, 5).g, 128);
        // The bar's first and last colour, below the map, over its whole width but for the margins.
        const auto row = map.row(30 + 6);
        EXPECT_NE(std::ranges::find(row, ramp.code(1.0)), row.end());
        EXPECT_EQ(row[6], ramp.code(0.0));
        EXPECT_EQ(row[row.size() - 7], ramp.code(1.0));
    }
}

TEST(DifferenceMap, LettersGrowWithThePicture) {
    const auto below = [](int width) {
        const Image<double> differences(width, 8);
        return difference_map(differences, difference_statistics(differences.view())).height() - 8;
    };
    EXPECT_EQ(below(16), below(300));
    EXPECT_EQ(below(1440), 4 * below(300));
}

TEST(DifferenceMap, ScalesWithoutAnEndAreRefused) {
    const Image<double> differences(4, 4);
    for (const double end :
         {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_THROW((void)difference_map(differences, {}, {.end = end}), std::invalid_argument) << end;
    }
}

}  // namespace
}  // namespace emulsion
