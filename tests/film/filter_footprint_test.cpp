// Splatting: which pixels a filter reaches, and with what weights.

#include "film/filter_footprint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "film/filter_sampler.h"
#include "filter_examples.h"

namespace emulsion {
namespace {

using testing::example_filters;
using testing::name_of;

/// The weights of the pixels reached.
std::vector<float> weights_at(const FilterFootprint& footprint, FilterAxis axis, float place_px) {
    std::vector<float> room(footprint.room(axis));
    const auto weights = footprint.weights(axis, place_px, room.data());
    const auto reach = footprint.reach(axis, place_px);
    EXPECT_EQ(weights.reached.begin, reach.begin);
    EXPECT_EQ(weights.reached.end, reach.end);
    return {weights.first, weights.first + std::max(0, reach.end - reach.begin)};
}

TEST(FilterFootprint, ReachesThePixelsWithinTheRadiusAndNoOthers) {
    for (const Filter& filter : example_filters()) {
        const FilterFootprint footprint(filter);
        const double radius = radius_px(filter, FilterAxis::x);
        Pcg32 random(1);
        for (int k = 0; k < 200; ++k) {
            const float place = 40.0f * random.next_float() - 20.0f;
            const auto reach = footprint.reach(FilterAxis::x, place);
            for (int i = -60; i < 60; ++i) {
                const double offset = i + 0.5 - static_cast<double>(place);
                EXPECT_EQ(i >= reach.begin && i < reach.end, -radius < offset && offset <= radius) << name_of(filter);
            }
            EXPECT_LE(static_cast<std::size_t>(reach.end - reach.begin), footprint.room(FilterAxis::x));
        }
    }
    const auto reach = FilterFootprint(MitchellFilter{}).reach(FilterAxis::x, 5.5f);
    EXPECT_EQ(reach.begin, 4) << "3 and 7 are at the radius itself, and one of them belongs";
    EXPECT_EQ(reach.end, 8);
}

// A place on the border of two pixels belongs to one of them.
TEST(FilterFootprint, BoxOfHalfAPixelReachesOnePixelFromEverywhere) {
    const FilterFootprint footprint(BoxFilter{});
    for (int k = -64; k < 64; ++k) {
        const float place = 0.125f * static_cast<float>(k);
        const auto reach = footprint.reach(FilterAxis::x, place);
        ASSERT_EQ(reach.end - reach.begin, 1) << place;
        EXPECT_EQ(reach.begin, static_cast<int>(std::floor(place)));
        EXPECT_EQ(weights_at(footprint, FilterAxis::x, place)[0], 1.0f);
    }
}

TEST(FilterFootprint, WeightsAreTheFilterOfMeanOne) {
    for (const Filter& filter : example_filters()) {
        const FilterFootprint footprint(filter);
        for (const FilterAxis axis : {FilterAxis::x, FilterAxis::y}) {
            const double radius = radius_px(filter, axis);
            // The mean over the support, and the scale by the reference.
            constexpr int kSteps = 200000;
            double sum = 0.0, sum_of_squares = 0.0;
            for (int i = 0; i < kSteps; ++i) {
                const double weight = footprint.weight_reference(axis, radius * (i + 0.5) / kSteps);
                sum += weight / kSteps;
                sum_of_squares += weight * weight / kSteps;
            }
            EXPECT_NEAR(sum, 1.0, 1e-7) << name_of(filter);
            const double middle = footprint.weight_reference(axis, 0.0);
            for (int i = 0; i < 50; ++i) {
                const double offset = radius * i / 50.0;
                EXPECT_NEAR(footprint.weight_reference(axis, offset),
                            middle * eval(filter, axis, offset) / eval(filter, axis, 0.0), 1e-12 * middle);
            }
            if (axis == FilterAxis::x && radius_px(filter, FilterAxis::y) == radius) {
                EXPECT_NEAR(footprint.mean_square_weight(), sum_of_squares * sum_of_squares, 1e-6 * sum_of_squares);
            }
        }
    }
}

TEST(FilterFootprint, FastPathFollowsItsTwin) {
    for (const Filter& filter : example_filters()) {
        const FilterFootprint footprint(filter);
        Pcg32 random(3);
        for (int k = 0; k < 2000; ++k) {
            const float place = 10.0f * random.next_float();
            const auto reach = footprint.reach(FilterAxis::y, place);
            const std::vector<float> weights = weights_at(footprint, FilterAxis::y, place);
            for (int i = reach.begin; i < reach.end; ++i) {
                const double expected = footprint.weight_reference(FilterAxis::y, i + 0.5 - static_cast<double>(place));
                // The cubic's 2e-6, and the rounding of weights of up to 3 in single precision.
                EXPECT_NEAR(static_cast<double>(weights[static_cast<std::size_t>(i - reach.begin)]), expected, 4e-6)
                    << name_of(filter);
            }
        }
    }
}

// Both axes at once, from either side of place 0 and from the places just below whole and half pixels.
TEST(FilterFootprint, FourByFourAreTheSameBitsAsAxisByAxis) {
    int quick = 0;
    for (const Filter& filter : example_filters()) {
        const FilterFootprint footprint(filter);
        Pcg32 random(5);
        const auto place = [&random] {
            const float any = 40.0f * random.next_float() - 8.0f;
            const float half = 0.5f * std::floor(2.0f * any);
            const std::array<float, 4> places = {any, half, std::nextafter(half, -100.0f), 70000.0f + any};
            return places[random.next() % 4u];
        };
        for (int k = 0; k < 4000; ++k) {
            const float x = place(), y = place();
            const auto block = footprint.four_by_four(x, y);
            if (!block) continue;
            ++quick;
            const auto xs = footprint.reach(FilterAxis::x, x), ys = footprint.reach(FilterAxis::y, y);
            ASSERT_EQ(xs.end - xs.begin, 4) << name_of(filter) << " from " << x;
            ASSERT_EQ(ys.end - ys.begin, 4) << name_of(filter) << " from " << y;
            ASSERT_EQ(block->x_px, xs.begin) << x;
            ASSERT_EQ(block->y_px, ys.begin) << y;
            const auto numbers = [](Float4 four) { return std::vector<float>{four[0], four[1], four[2], four[3]}; };
            ASSERT_EQ(numbers(block->x_weights), weights_at(footprint, FilterAxis::x, x)) << x;
            ASSERT_EQ(numbers(block->y_weights), weights_at(footprint, FilterAxis::y, y)) << y;
        }
    }
    EXPECT_GT(quick, 4000) << "several filters have radius 2";
    const FilterFootprint mitchell{MitchellFilter{}};
    EXPECT_TRUE(mitchell.four_by_four(0.0f, 3.999f));
    EXPECT_FALSE(mitchell.four_by_four(-0.001f, 3.999f));
    EXPECT_FALSE(FilterFootprint(MitchellFilter{3.0f}).four_by_four(5.2f, 5.2f));
}

// Shapes far narrower than a cell of the table are evaluated themselves.
TEST(FilterFootprint, NarrowShapesAreNoCubics) {
    const Filter filter = GaussianFilter{2.0f, 2.0f, 0.004f};
    const FilterFootprint footprint(filter);
    for (const float place : {10.5f, 10.503f, 10.51f, 10.52f}) {
        const double offset = 10.5 - static_cast<double>(place);
        const double expected = footprint.weight_reference(FilterAxis::x, offset);
        const int first = footprint.reach(FilterAxis::x, place).begin;
        const float weight = weights_at(footprint, FilterAxis::x, place)[static_cast<std::size_t>(10 - first)];
        EXPECT_NEAR(static_cast<double>(weight), expected, 1e-6 * footprint.weight_reference(FilterAxis::x, 0.0));
    }
}

TEST(FilterFootprint, PlacesAndPixelsReachEachOther) {
    for (const Filter& filter : example_filters()) {
        const FilterFootprint footprint(filter);
        const PixelBounds pixels{3, -2, 9, 4};
        const PixelBounds places = footprint.places_that_reach(pixels);
        const auto reaches = [&](float x, float y) {
            const auto xs = footprint.reach(FilterAxis::x, x), ys = footprint.reach(FilterAxis::y, y);
            return std::max(xs.begin, pixels.x0) < std::min(xs.end, pixels.x1) &&
                   std::max(ys.begin, pixels.y0) < std::min(ys.end, pixels.y1);
        };
        Pcg32 random(5);
        for (int k = 0; k < 2000; ++k) {
            const float x = 30.0f * random.next_float() - 10.0f, y = 30.0f * random.next_float() - 12.0f;
            const bool is_inside = x >= static_cast<float>(places.x0) && x <= static_cast<float>(places.x1) &&
                                   y >= static_cast<float>(places.y0) && y <= static_cast<float>(places.y1);
            EXPECT_TRUE(is_inside || !reaches(x, y)) << name_of(filter) << x << ' ' << y;
        }
        // From the corners of a region, all that is reached lies within what reached_from() says.
        const PixelBounds reached = footprint.reached_from(places);
        for (const int x : {places.x0, places.x1}) {
            const auto reach = footprint.reach(FilterAxis::x, static_cast<float>(x));
            if (reach.begin >= reach.end) continue;
            EXPECT_GE(reach.begin, reached.x0);
            EXPECT_LE(reach.end, reached.x1);
        }
        EXPECT_TRUE(reached.contains(pixels));
    }
}

TEST(FilterFootprint, RefusesFiltersWiderThanPictures) {
    EXPECT_THROW(FilterFootprint(BoxFilter{1e6f, 1.0f}), std::invalid_argument);
    EXPECT_THROW(FilterFootprint(BoxFilter{1.0f, -1.0f}), std::invalid_argument);
    EXPECT_NO_THROW(FilterFootprint(BoxFilter{65536.0f, 1.0f}));
}

// Sampled by importance, a weight's mean square is that of the sampler's own weights.
TEST(FilterSamplerWeights, MeanSquareIsThatOfTheSamples) {
    for (const Filter& filter : example_filters()) {
        const FilterSampler sampler(filter);
        // Along one axis and the other: weights are products.
        constexpr int kSteps = 40 * FilterSampler::kCells;
        const auto square = [&](double u, double v) { return std::pow(sampler.sample_reference(u, v).weight, 2.0); };
        double along_x = 0.0, along_y = 0.0;
        for (int i = 0; i < kSteps; ++i) {
            along_x += square((i + 0.5) / kSteps, 0.5) / kSteps;
            along_y += square(0.5, (i + 0.5) / kSteps) / kSteps;
        }
        const double sum = along_x * along_y / square(0.5, 0.5);
        EXPECT_NEAR(sampler.mean_square_weight(), sum, 1e-3 * sum) << name_of(filter);
    }
}

// Shapes of less than a pixel in a support of thousands: the mean weight is still 1.
TEST(FilterFootprint, WideSupportsOfNarrowShapesAreNormalised) {
    for (const float radius : {4096.0f, 65536.0f}) {
        const FilterFootprint footprint(GaussianFilter{radius, 2.0f, 0.25f});
        constexpr double kStep = 1.0 / 64.0;  // of midpoints: 16 to a standard deviation
        double integral = 0.0;
        for (int i = -256; i < 256; ++i)
            integral += kStep * footprint.weight_reference(FilterAxis::x, (i + 0.5) * kStep);
        EXPECT_NEAR(integral / (2.0 * static_cast<double>(radius)), 1.0, 1e-6) << radius;
    }
}

}  // namespace
}  // namespace emulsion
