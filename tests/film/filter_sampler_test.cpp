#include "film/filter_sampler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "filter_examples.h"
#include "support/chi_square.h"

namespace emulsion {
namespace {

using emulsion::testing::example_filters;
using emulsion::testing::name_of;

/// The integral of f(x) g(x) along an axis, by midpoints.
template <class G>
double integrate(const Filter& filter, FilterAxis axis, const G& g) {
    constexpr int kSteps = 40000;
    const double radius = radius_px(filter, axis), step = 2.0 * radius / kSteps;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double x = -radius + (i + 0.5) * step;
        sum += step * eval(filter, axis, x) * g(x);
    }
    return sum;
}

double one(double) { return 1.0; }

TEST(FilterSampler, BoxIsExact) {
    const FilterSampler sampler(BoxFilter{0.5f, 2.0f});
    EXPECT_EQ(sampler.sample(0.0f, 0.5f).x_offset_px, -0.5f);
    EXPECT_EQ(sampler.sample(0.0f, 0.5f).y_offset_px, 0.0f);
    EXPECT_EQ(sampler.sample(0.75f, 0.875f).x_offset_px, 0.25f);
    EXPECT_EQ(sampler.sample(0.75f, 0.875f).y_offset_px, 1.5f);
    EXPECT_LT(sampler.sample(0x1.fffffep-1f, 0.0f).x_offset_px, 0.5f);
    Pcg32 random(1);
    for (int i = 0; i < 1000; ++i) EXPECT_EQ(sampler.sample(random.next_float(), random.next_float()).weight, 1.0f);
}

// On a fine grid of u the offsets rise: low-discrepancy points stay so. The ends are the ends of the support.
TEST(FilterSampler, KeepsOrderAndStaysInTheSupport) {
    for (const Filter& filter : example_filters()) {
        const FilterSampler sampler(filter);
        const auto radius = static_cast<float>(radius_px(filter, FilterAxis::x));
        float last = -radius;
        for (int i = 0; i < (1 << 16); ++i) {
            const float x = sampler.sample(static_cast<float>(i) * 0x1p-16f, 0.5f).x_offset_px;
            ASSERT_GE(x, last);
            last = x;
        }
        EXPECT_EQ(sampler.sample(0.0f, 0.5f).x_offset_px, -radius);
        EXPECT_LE(last, radius);
        EXPECT_LE(sampler.sample(0x1.fffffep-1f, 0.5f).x_offset_px, radius);
    }
}

// The fast path (cubics, single precision) beside its twin, on random points.
TEST(FilterSampler, AgreesWithTheReference) {
    for (const Filter& filter : example_filters()) {
        const FilterSampler sampler(filter);
        Pcg32 random(2);
        for (int i = 0; i < 20000; ++i) {
            const float u = random.next_float(), v = random.next_float();
            const FilterSample sample = sampler.sample(u, v);
            const auto reference = sampler.sample_reference(static_cast<double>(u), static_cast<double>(v));
            ASSERT_NEAR(static_cast<double>(sample.weight), reference.weight, 1e-5) << name_of(filter);
            ASSERT_NEAR(static_cast<double>(sample.x_offset_px), reference.x_offset_px,
                        1e-6 * radius_px(filter, FilterAxis::x));
            ASSERT_NEAR(static_cast<double>(sample.y_offset_px), reference.y_offset_px,
                        1e-6 * radius_px(filter, FilterAxis::y));
        }
    }
}

// The reference's weight is the filter over the density, both taken at the sample's place.
TEST(FilterSampler, WeightIsTheFilterOverTheDensity) {
    for (const Filter& filter : example_filters()) {
        const FilterSampler sampler(filter);
        const double norm = integrate(filter, FilterAxis::x, one) * integrate(filter, FilterAxis::y, one);
        Pcg32 random(6);
        for (int i = 0; i < 1000; ++i) {
            const double u = static_cast<double>(random.next_float()) + 0x1p-30,
                         v = static_cast<double>(random.next_float()) + 0x1p-30;
            const auto sample = sampler.sample_reference(u, v);
            const double f =
                eval(filter, FilterAxis::x, sample.x_offset_px) * eval(filter, FilterAxis::y, sample.y_offset_px);
            const double density =
                sampler.pdf(FilterAxis::x, sample.x_offset_px) * sampler.pdf(FilterAxis::y, sample.y_offset_px);
            ASSERT_NEAR(sample.weight, f / norm / density, 1e-6 * (1.0 + std::abs(sample.weight))) << name_of(filter);
        }
    }
}

// By quadrature along u instead of at random: the mean of the weights is 1 far below any sampling error.
TEST(FilterSampler, WeightsHaveMeanOne) {
    for (const Filter& filter : example_filters()) {
        const FilterSampler sampler(filter);
        const double middle = static_cast<double>(sampler.sample(0.5f, 0.5f).weight);
        constexpr int kSteps = 1 << 17;
        double x_mean = 0.0, y_mean = 0.0;
        for (int i = 0; i < kSteps; ++i) {
            const float u = (static_cast<float>(i) + 0.5f) / kSteps;
            x_mean += static_cast<double>(sampler.sample(u, 0.5f).weight) / kSteps;
            y_mean += static_cast<double>(sampler.sample(0.5f, u).weight) / kSteps;
        }
        // Each is the other axis' weight in the middle; the product of the axes' weights in the middle is `middle`.
        EXPECT_NEAR(x_mean * y_mean / middle, 1.0, 2e-6);
    }
}

// The positions against pdf(): chi^2 of 40 bins along each axis. All tests together have a false alarm in 1,000 seeds.
TEST(FilterSampler, HistogramFollowsTheDensity) {
    constexpr int kBins = 40, kCount = 100000, kStepsPerBin = 2000;
    for (const Filter& filter : example_filters()) {
        const FilterSampler sampler(filter);
        for (const FilterAxis axis : {FilterAxis::x, FilterAxis::y}) {
            const double radius = radius_px(filter, axis);
            std::array<double, kBins> observed{}, expected{};
            Pcg32 random(3);
            for (int i = 0; i < kCount; ++i) {
                const FilterSample sample = sampler.sample(random.next_float(), random.next_float());
                const auto x = static_cast<double>(axis == FilterAxis::x ? sample.x_offset_px : sample.y_offset_px);
                const int bin = static_cast<int>((x + radius) / (2.0 * radius) * kBins);
                observed[static_cast<std::size_t>(std::min(bin, kBins - 1))] += 1.0;
            }
            constexpr int kSteps = kBins * kStepsPerBin;
            for (int i = 0; i < kSteps; ++i) {
                expected[static_cast<std::size_t>(i / kStepsPerBin)] +=
                    sampler.pdf(axis, radius * (2.0 * (i + 0.5) / kSteps - 1.0)) * 2.0 * radius / kSteps * kCount;
            }
            const int tests = 2 * static_cast<int>(example_filters().size());
            EXPECT_GT(testing::chi_square_test(observed, expected).p_value, testing::sidak_level(1e-3, tests))
                << name_of(filter);
        }
    }
}

// pdf() against |f|: the area between the two densities. Cells as wide as the filter would show 0.1 and more.
TEST(FilterSampler, DensityIsCloseToTheAbsoluteFilter) {
    for (const Filter& filter : example_filters()) {
        const FilterSampler sampler(filter);
        for (const FilterAxis axis : {FilterAxis::x, FilterAxis::y}) {
            const double radius = radius_px(filter, axis);
            constexpr int kSteps = 40000;
            const double step = 2.0 * radius / kSteps;
            double mass = 0.0, difference = 0.0;
            const auto x = [&](int i) { return -radius + (i + 0.5) * step; };
            for (int i = 0; i < kSteps; ++i) mass += step * std::abs(eval(filter, axis, x(i)));
            for (int i = 0; i < kSteps; ++i) {
                difference += step * std::abs(sampler.pdf(axis, x(i)) - std::abs(eval(filter, axis, x(i))) / mass);
            }
            EXPECT_LT(difference, 0.02) << name_of(filter);
        }
    }
}

// Expectations: the mean of weight * g(x) h(y) is the filter-weighted mean of g h. z-tests over 18 filters and 3
// functions; together a false alarm in 1,000 runs: each at 1.9e-5, |z| < 4.29.
TEST(FilterSampler, EstimatesFilterWeightedIntegrals) {
    const std::array<double (*)(double), 3> functions = {[](double x) { return std::exp(0.4 * x); },
                                                         [](double x) { return x > 0.3 ? 1.0 : 0.0; },
                                                         [](double x) { return 2.0 + std::sin(3.0 * x + 1.0); }};
    for (const Filter& filter : example_filters()) {
        const FilterSampler sampler(filter);
        for (const auto& g : functions) {
            const double expected = integrate(filter, FilterAxis::x, g) / integrate(filter, FilterAxis::x, one) *
                                    integrate(filter, FilterAxis::y, g) / integrate(filter, FilterAxis::y, one);
            Pcg32 random(4);
            constexpr int kCount = 100000;
            double sum = 0.0, squares = 0.0;
            for (int i = 0; i < kCount; ++i) {
                const FilterSample sample = sampler.sample(random.next_float(), random.next_float());
                const double value = static_cast<double>(sample.weight) * g(static_cast<double>(sample.x_offset_px)) *
                                     g(static_cast<double>(sample.y_offset_px));
                sum += value;
                squares += value * value;
            }
            const double mean = sum / kCount, variance = squares / kCount - mean * mean;
            EXPECT_LT(std::abs(mean - expected) / std::sqrt(variance / kCount), 4.29) << name_of(filter);
        }
    }
}

// The density integrates to 1 along an axis, and is that of the positions: 0 outside.
TEST(FilterSampler, PdfIsADensity) {
    for (const Filter& filter : example_filters()) {
        const FilterSampler sampler(filter);
        const double radius = radius_px(filter, FilterAxis::y);
        constexpr int kSteps = 1 << 18;
        double sum = 0.0;
        for (int i = 0; i < kSteps; ++i) {
            sum += sampler.pdf(FilterAxis::y, radius * (2.0 * (i + 0.5) / kSteps - 1.0)) * 2.0 * radius / kSteps;
        }
        EXPECT_NEAR(sum, 1.0, 1e-3);
        EXPECT_EQ(sampler.pdf(FilterAxis::y, radius), 0.0);
        EXPECT_EQ(sampler.pdf(FilterAxis::y, -1.5 * radius), 0.0);
    }
}

TEST(FilterSampler, RefusesWhatCannotBeNormalised) {
    EXPECT_THROW(FilterSampler(BoxFilter{-1.0f, 1.0f}), std::invalid_argument);
    EXPECT_THROW(FilterSampler(GaussianFilter{1e3f, 1e3f, 1e-30f}), std::invalid_argument);
    EXPECT_NO_THROW(FilterSampler(MitchellFilter{2.0f, 2.0f, 0.0f, 3.0f}));
}

}  // namespace
}  // namespace emulsion
