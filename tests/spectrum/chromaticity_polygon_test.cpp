#include "spectrum/chromaticity_polygon.h"

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace emulsion {
namespace {

constexpr std::array<Chromaticity, 4> kSquare = {{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}};

TEST(ConvexHull, KeepsTheCornersOnly) {
    const std::array<Chromaticity, 8> points = {
        {{1.0, 1.0}, {0.5, 0.0}, {0.0, 1.0}, {0.25, 0.5}, {1.0, 0.0}, {0.0, 0.0}, {0.0, 0.5}, {1.0, 1.0}}};
    const std::vector<Chromaticity> hull = convex_hull(points);
    EXPECT_EQ(hull, (std::vector<Chromaticity>{kSquare.begin(), kSquare.end()})) << "counter-clockwise from the left";
}

TEST(ConvexHull, OfALineIsNoPolygon) {
    EXPECT_LT(convex_hull(std::array<Chromaticity, 3>{{{0.0, 0.0}, {0.5, 0.5}, {1.0, 1.0}}}).size(), 3U);
    EXPECT_EQ(convex_hull(std::array<Chromaticity, 2>{{{0.0, 0.0}, {0.0, 0.0}}}).size(), 1U);
    EXPECT_TRUE(convex_hull({}).empty());
}

TEST(SignedDistance, IsTheDistanceFromTheNearestEdgeOrCorner) {
    EXPECT_DOUBLE_EQ(signed_distance(kSquare, {0.5, 0.5}), 0.5);
    EXPECT_DOUBLE_EQ(signed_distance(kSquare, {0.25, 0.6}), 0.25);
    EXPECT_EQ(signed_distance(kSquare, {1.0, 0.3}), 0.0);
    EXPECT_DOUBLE_EQ(signed_distance(kSquare, {1.5, 0.3}), -0.5) << "beside an edge";
    EXPECT_DOUBLE_EQ(signed_distance(kSquare, {-3.0, -4.0}), -5.0) << "beyond a corner";
    EXPECT_TRUE(std::isnan(signed_distance(kSquare, {std::numeric_limits<double>::quiet_NaN(), 0.0})));
}

}  // namespace
}  // namespace emulsion
