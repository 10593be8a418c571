#include "pathtracer/equal_area.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "core/random.h"

namespace emulsion {
namespace {

void expect_near(const Imath::V3d& found, const Imath::V3d& expected, double tolerance) {
    EXPECT_NEAR((found - expected).length(), 0.0, tolerance) << found << ", expected " << expected;
}

TEST(EqualArea, LandmarksAreWhereTheyAreInPbrt) {
    const double half = std::sqrt(0.5);
    const std::pair<Imath::V2d, Imath::V3d> landmarks[] = {
        {{0.5, 0.5}, {0, 0, 1}}, {{0, 0}, {0, 0, -1}},
        {{1, 0}, {0, 0, -1}},    {{0, 1}, {0, 0, -1}},
        {{1, 1}, {0, 0, -1}},    {{1, 0.5}, {1, 0, 0}},
        {{0, 0.5}, {-1, 0, 0}},  {{0.5, 1}, {0, 1, 0}},
        {{0.5, 0}, {0, -1, 0}},  {{0.75, 0.75}, {half, half, 0}},
    };
    for (const auto& [place, direction] : landmarks) expect_near(equal_area_direction(place), direction, 1e-15);
}

TEST(EqualArea, DirectionsComeBack) {
    Pcg32 random(1);
    for (int i = 0; i < 10000; ++i) {
        const Imath::V2d place(random.next_float(), random.next_float());
        const Imath::V3d direction = equal_area_direction(place);
        EXPECT_NEAR(direction.length(), 1.0, 1e-15);
        // A step of 1e-8 in direction next to a pole is one of 1e-8 in the square, too: the map is smooth there.
        expect_near(equal_area_direction(equal_area_place(direction)), direction, 1e-14);
        EXPECT_NEAR((equal_area_place(direction) - place).length(), 0.0, 1e-12) << place;
    }
}

// The Jacobian, by differences: the area of the image of a small square is 4 pi times its own, everywhere.
TEST(EqualArea, AreasAreKept) {
    Pcg32 random(2);
    constexpr double kStep = 1e-4;
    for (int i = 0; i < 1000; ++i) {
        const Imath::V2d p(0.001 + 0.998 * random.next_float(), 0.001 + 0.998 * random.next_float());
        // Not across a fold: the diagonals of the square, and its axes.
        const double u = std::abs(2.0 * p.x - 1.0), v = std::abs(2.0 * p.y - 1.0);
        if (u < 0.001 || v < 0.001 || std::abs(u + v - 1.0) < 0.001) continue;
        const auto difference = [&](const Imath::V2d& step) {
            return (equal_area_direction(p + step) - equal_area_direction(p - step)) / (2.0 * kStep);
        };
        const double jacobian = difference({kStep, 0.0}).cross(difference({0.0, kStep})).length();
        // Central differences are off by step^2 times a third derivative, which grows as 1/radius^2 next to the poles.
        const double radius = std::min(u + v, 2.0 - u - v);
        EXPECT_NEAR(jacobian / (4.0 * std::numbers::pi), 1.0, 20.0 * kStep * kStep / (radius * radius) + 1e-8) << p;
    }
}

TEST(EqualArea, BeyondAnEdgeComesTheSquareAgain) {
    // Two places on both sides of an edge, close to it, are close on the sphere.
    constexpr double kClose = 1e-5;
    for (const double along : {0.01, 0.25, 0.5, 0.66, 0.99}) {
        const std::pair<Imath::V2d, Imath::V2d> pairs[] = {
            {{along, kClose}, {along, -kClose}},
            {{along, 1 - kClose}, {along, 1 + kClose}},
            {{kClose, along}, {-kClose, along}},
            {{1 - kClose, along}, {1 + kClose, along}},
        };
        for (const auto& [inside, outside] : pairs) {
            const Imath::V2d wrapped = wrapped_equal_area_place(outside);
            EXPECT_TRUE(wrapped.x >= 0.0 && wrapped.x <= 1.0 && wrapped.y >= 0.0 && wrapped.y <= 1.0) << wrapped;
            expect_near(equal_area_direction(wrapped), equal_area_direction(inside), 20.0 * kClose);
        }
    }
    // Past a corner, where all is around the pole: 1 + z = r^2, and the place is 4 steps from it in [-1, 1]^2.
    const double r = 4.0 * kClose;
    EXPECT_NEAR(equal_area_direction(wrapped_equal_area_place({-kClose, 1 + kClose})).z, r * r - 1.0, 1e-15);
    EXPECT_EQ(wrapped_equal_area_place({0.25, 0.75}), Imath::V2d(0.25, 0.75));
}

}  // namespace
}  // namespace emulsion
