#include "support/density_check.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/random.h"

namespace emulsion::testing {
namespace {

constexpr double kPi = std::numbers::pi;

/// What a right sampler passes: once in 100,000 seeds it does not.
constexpr double kLevel = 1e-5;

double number(Pcg32& random) { return static_cast<double>(random.next_float()); }

Direction about_z(double cosine, double angle) {
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    return {sine * std::cos(angle), sine * std::sin(angle), cosine};
}

DensityCheckResult check_uniform_square(const PointDensity& density) {
    Pcg32 random(1);
    return check_point_density(
        [&]() -> std::optional<SquarePoint> {
            return SquarePoint{number(random), number(random)};
        },
        density);
}

TEST(PointDensity, OfTheUnitSquare) {
    const DensityCheckResult right = check_uniform_square([](const SquarePoint&) { return 1.0; });
    EXPECT_GT(right.p_value, kLevel);
    EXPECT_NEAR(right.integral, 1.0, 1e-12);
    EXPECT_EQ(right.drawn_share, 1.0);
    // A density that is right in the mean only, one that is too small, and one that is too large.
    EXPECT_LT(check_uniform_square([](const SquarePoint& p) { return 0.9 + 0.2 * p[1]; }).p_value, kLevel);
    EXPECT_LT(check_uniform_square([](const SquarePoint&) { return 0.99; }).p_value, kLevel);
    EXPECT_LT(check_uniform_square([](const SquarePoint&) { return 1.01; }).p_value, kLevel);
}

// An edge that bins know nothing of, and draws that yield nothing.
TEST(PointDensity, MayHaveEdges) {
    Pcg32 random(2);
    const auto inside = [](const SquarePoint& p) { return p[0] + 0.7 * p[1] < 0.81; };
    const auto sampler = [&]() -> std::optional<SquarePoint> {
        const SquarePoint point = {number(random), number(random)};
        if (!inside(point)) return std::nullopt;
        return point;
    };
    const auto check = [&](double height) {
        return check_point_density(sampler, [&](const SquarePoint& p) { return inside(p) ? height : 0.0; });
    };
    const double area = 0.81 * 0.81 / 1.4 - (0.81 - 0.7) * (0.81 - 0.7) / 1.4;
    EXPECT_NEAR(check(1.0).integral, area, 1e-5);
    EXPECT_NEAR(check(1.0).drawn_share, area, 0.0032);  // four deviations
    EXPECT_GT(check(1.0).p_value, kLevel);
    EXPECT_LT(check(0.98).p_value, kLevel);
    EXPECT_LT(check(1.02).p_value, kLevel);
}

TEST(DirectionDensity, OfTheSphere) {
    Pcg32 random(3);
    const auto sampler = [&]() -> std::optional<Direction> {
        const double z = 2.0 * number(random) - 1.0;
        return about_z(z, 2.0 * kPi * number(random));
    };
    const Direction axis = {0.3, -2.0, 0.5};
    EXPECT_GT(check_direction_density(
                  sampler, [](const Direction&) { return 0.25 / kPi; }, axis)
                  .p_value,
              kLevel);
    const auto tilted = [](const Direction& d) { return 0.25 / kPi * (1.0 + 0.1 * d[0]); };
    EXPECT_LT(check_direction_density(sampler, tilted, axis).p_value, kLevel);
}

// A classic: the angle instead of its cosine drawn evenly crowds the pole.
TEST(DirectionDensity, NoticesCrowdedPoles) {
    Pcg32 random(4);
    const auto sampler = [&]() -> std::optional<Direction> {
        const double theta = 0.5 * kPi * number(random);
        return about_z(std::cos(theta), 2.0 * kPi * number(random));
    };
    const auto uniform = [](const Direction& d) { return d[2] > 0.0 ? 0.5 / kPi : 0.0; };
    const DensityCheckResult result = check_direction_density(sampler, uniform, {0, 0, 1});
    EXPECT_NEAR(result.integral, 1.0, 1e-4);
    EXPECT_LT(result.p_value, 1e-100);
}

// Lobes of a thousandth of a radian: a bin of even width would hold them whole, and any sampler would pass.
TEST(DirectionDensity, SeesIntoNarrowLobes) {
    constexpr double kWidth = 1e-3;
    Pcg32 random(5);
    const auto sampler_of = [&](double width) {
        return [&random, width]() -> std::optional<Direction> {
            const double radius = width * std::sqrt(-2.0 * std::log1p(-number(random)));
            return about_z(1.0 / std::sqrt(1.0 + radius * radius), 2.0 * kPi * number(random));
        };
    };
    // The same normal distribution in the plane z = 1, seen from the origin.
    const auto density = [](const Direction& d) {
        if (d[2] <= 0.0) return 0.0;
        const double x = d[0] / d[2] / kWidth, y = d[1] / d[2] / kWidth;
        return std::exp(-0.5 * (x * x + y * y)) / (2.0 * kPi * kWidth * kWidth * d[2] * d[2] * d[2]);
    };
    EXPECT_GT(check_direction_density(sampler_of(kWidth), density, {0, 0, 1}).p_value, kLevel);
    EXPECT_LT(check_direction_density(sampler_of(1.02 * kWidth), density, {0, 0, 1}).p_value, kLevel);
}

}  // namespace
}  // namespace emulsion::testing
