// Local adaptations: what each of them sees about a pixel.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "tonemap/adaptation.h"
#include "tonemap/gaussian_rows.h"
#include "tonemap/scale_selection.h"

namespace emulsion {
namespace {

template <class T>
Image<T> constant(int width, int height, T value) {
    Image<T> image(width, height);
    std::fill(image.pixels().begin(), image.pixels().end(), value);
    return image;
}

/// `left` in the left half, `right` in the right one.
template <class T>
Image<T> two_halves(int width, int height, T left, T right) {
    Image<T> image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) image(x, y) = x < width / 2 ? left : right;
    }
    return image;
}

template <class T>
Image<T> log_noise(int width, int height, unsigned seed) {
    Pcg32 random(seed);
    Image<T> image(width, height);
    for (T& value : image.pixels()) value = static_cast<T>(std::pow(10.0f, 2.0f * random.next_float() - 1.0f));
    return image;
}

template <class T>
Image<T> turned(const Image<T>& image) {
    Image<T> result(image.height(), image.width());
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) result(image.height() - 1 - y, x) = image(x, y);
    }
    return result;
}

/// Calls test(adaptation) for every local one, with its defaults.
template <class Test>
void for_each_local(const Test& test) {
    for_each_alternative<Adaptation>([&]<class T>(const T& adaptation) {
        if constexpr (requires { local_luminance(adaptation, Image<float>(), 1); }) {
            SCOPED_TRACE(std::string(T::kName));
            test(adaptation);
        }
    });
}

TEST(LocalLuminance, IsSaidToBeLocal) {
    EXPECT_FALSE(is_local(LogAverageAdaptation{}));
    EXPECT_FALSE(is_local(SpotAdaptation{}));
    for_each_local([](const auto& adaptation) { EXPECT_TRUE(is_local(adaptation)); });
}

TEST(LocalLuminance, OfAConstantPictureIsThatConstant) {
    for_each_local([](const auto& adaptation) {
        for (const auto& [width, height] : {std::pair{1, 1}, {1, 97}, {97, 1}, {64, 61}}) {
            const Image<float> local = local_luminance(adaptation, constant(width, height, 7.0f), 1);
            for (const float value : local.pixels()) EXPECT_NEAR(value, 7.0f, 1e-5f);
        }
    });
}

TEST(LocalLuminance, OfABlackPictureIsBlackOrPositive) {
    for_each_local([](const auto& adaptation) {
        const Image<float> local = local_luminance(adaptation, constant(9, 33, 0.0f), 1);
        const Image<double> exact = local_luminance_reference(adaptation, constant(9, 33, 0.0));
        for (const float value : local.pixels()) {
            EXPECT_TRUE(std::isfinite(value) && value >= 0.0f);
        }
        for (const double value : exact.pixels()) {
            EXPECT_TRUE(std::isfinite(value) && value >= 0.0);
        }
    });
}

TEST(LocalLuminance, StaysWithinTheValuesOfThePicture) {
    for_each_local([](const auto& adaptation) {
        const Image<float> local = local_luminance(adaptation, two_halves(200, 50, 1e-30f, 1e30f), 1);
        for (const float value : local.pixels()) {
            EXPECT_GE(value, 0.999e-30f);
            EXPECT_LE(value, 1.001e30f);
        }
    });
}

TEST(LocalLuminance, SameBitsForEveryNumberOfThreads) {
    for_each_local([](const auto& adaptation) {
        const Image<float> picture = log_noise<float>(301, 203, 1), one = local_luminance(adaptation, picture, 1);
        for (const int threads : {2, 3, 0}) EXPECT_EQ(local_luminance(adaptation, picture, threads), one) << threads;
    });
}

// But for rounding the same, also where sizes don't divide by all halvings.
TEST(LocalLuminance, TurnsWithThePicture) {
    for_each_local([](const auto& adaptation) {
        for (const auto& [width, height] : {std::pair{128, 64}, {83, 59}, {7, 101}}) {
            const Image<float> picture = log_noise<float>(width, height, 2);
            const Image<float> before = turned(local_luminance(adaptation, picture, 1));
            const Image<float> after = local_luminance(adaptation, turned(picture), 1);
            for (std::size_t i = 0; i < before.pixels().size(); ++i) {
                EXPECT_NEAR(after.pixels()[i], before.pixels()[i], 3e-5f * before.pixels()[i]) << i;
            }
        }
    });
}

// Of one decade of noise; a tenth of a percent of the pixels may be off by more, where a scale just is or is not taken.
TEST(LocalLuminance, AgreesWithItsTwinOnNoise) {
    for_each_local([](const auto& adaptation) {
        const Image<float> fast = local_luminance(adaptation, log_noise<float>(96, 80, 3), 0);
        const Image<double> exact = local_luminance_reference(adaptation, log_noise<double>(96, 80, 3));
        std::vector<double> errors;
        for (std::size_t i = 0; i < fast.pixels().size(); ++i) {
            errors.push_back(std::abs(fast.pixels()[i] / exact.pixels()[i] - 1.0));
        }
        std::sort(errors.begin(), errors.end());
        EXPECT_LE(errors[errors.size() / 2], 0.01);
        EXPECT_LE(errors[errors.size() * 999 / 1000], 0.15);
    });
}

// Two planes, 1 : 1000. An adaptation that stops at edges keeps both, right up to the edge; one that doesn't has a
// halo.
TEST(LocalLuminance, EdgesStopAllButUniformRadius) {
    const Image<float> picture = two_halves(256, 32, 1.0f, 1000.0f);
    const auto beside_edge = [&](const auto& adaptation) { return local_luminance(adaptation, picture, 1)(126, 16); };
    EXPECT_NEAR(beside_edge(BilateralAdaptation{}), 1.0f, 0.01f);
    EXPECT_LT(beside_edge(VaryingRadiusAdaptation{}), 2.0f);
    EXPECT_LT(beside_edge(CentreSurroundAdaptation{}), 10.0f);
    EXPECT_GT(beside_edge(UniformRadiusAdaptation{0.5f}), 300.0f);
}

TEST(UniformRadius, IsAGaussianOfHalfTheRadius) {
    const Image<double> picture = log_noise<double>(60, 40, 4);
    EXPECT_EQ(local_luminance_reference(UniformRadiusAdaptation{0.25f}, picture),
              gaussian_blur_reference(picture, 5.0));
}

// One pixel among black: no neighbourhood is like it.
TEST(VaryingRadius, PixelAmongBlackKeepsToItself) {
    Image<double> picture(31, 31);
    picture(15, 15) = 1.0;
    EXPECT_EQ(local_luminance_reference(VaryingRadiusAdaptation{0.2f}, picture)(15, 15), 1.0);
}

// A bright pixel does not darken the ones beside it: of the narrowest Gaussian they would have 23 cd/m^2.
TEST(CentreSurround, NoRimAboutABrightPixel) {
    Image<double> picture = constant(31, 31, 1.0);
    picture(15, 15) = 1000.0;
    EXPECT_DOUBLE_EQ(local_luminance_reference(CentreSurroundAdaptation{}, picture)(14, 15), 1.0);
}

// A scale is accepted below half of the limit, and isn't above one and a half of it; in between it is in part. Two
// scales on a plane with a dot, of which B_0, B_1 and B_2 are known.
TEST(ScaleSelection, BlendsAboutTheLimit) {
    Image<double> picture = constant(41, 41, 1.0);
    picture(20, 20) = 50.0;
    ScaleSelection selection{{0.3, 0.6, 1.2}, {0.0, 0.0}, 1.0};
    std::vector<double> level;
    for (const double sigma : selection.sigma_px) level.push_back(gaussian_blur_reference(picture, sigma)(20, 20));
    const double first = (level[0] - level[1]) / level[0], second = (level[1] - level[2]) / level[1];
    const auto chosen = [&](double limit) {
        selection.limit = limit;
        return select_scales_reference(selection, picture)(20, 20);
    };
    ASSERT_LT(first, second);
    EXPECT_NEAR(chosen(2.01 * second), level[1], 1e-9);
    EXPECT_NEAR(chosen(first / 1.51), 50.0, 1e-9);
    // The second scale is accepted by a half, the first one by what lies below one and a half.
    const double half_way = 0.5 * (level[0] + level[1]);
    EXPECT_NEAR(chosen(second), 50.0 + (1.5 - first / second) * (half_way - 50.0), 1e-9);
}

// The first scale that is not accepted ends it, even if wider ones would be.
TEST(ScaleSelection, StopsAtTheFirstContrast) {
    const Image<double> picture = two_halves(200, 5, 1.0, 100.0);
    const ScaleSelection selection{{0.25, 0.5, 1.0, 2.0, 4.0}, {0.0, 0.0, 0.0, 0.0}, 0.2};
    EXPECT_NEAR(select_scales_reference(selection, picture)(98, 2), 1.0, 0.1);
    EXPECT_NEAR(select_scales_reference(selection, picture)(80, 2), 1.0, 1e-3);
}

}  // namespace
}  // namespace emulsion
