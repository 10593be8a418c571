// Spectra for RGB colours: at the boundary of the gamut, and in the dark.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <gtest/gtest.h>

#include "core/matrix3.h"
#include "spectrum/rgb_space.h"
#include "spectrum/rgb_uplift.h"
#include "spectrum/sigmoid.h"

namespace emulsion::stability {
namespace {

/// The reflectance c0 + c1 cos t + c2 sin t, t once round over 400 to 700 nm, that has the colour: three linear
/// equations. Source: Glassner, "How to Derive a Spectrum from an RGB Triplet", IEEE CG&A 9(4), 1989.
PiecewiseLinearSpectrum linear_uplift(const RgbUplift& space, const RGBd& rgb) {
    const auto wave = [](const std::array<double, 3>& c) {
        PiecewiseLinearSpectrum spectrum;
        for (int nm = 360; nm <= 830; ++nm) {
            const double t = 2.0 * std::numbers::pi * std::clamp((nm - 400.0) / 300.0, 0.0, 1.0);
            spectrum.lambda_nm.push_back(nm);
            spectrum.value.push_back(c[0] + c[1] * std::cos(t) + c[2] * std::sin(t));
        }
        return spectrum;
    };
    Matrix3 rgb_from_c;
    for (std::size_t k = 0; k < 3; ++k) {
        std::array<double, 3> unit{};
        unit[k] = 1.0;
        const RGBd column = space.rgb_of(wave(unit));
        rgb_from_c.m[0][k] = column.r, rgb_from_c.m[1][k] = column.g, rgb_from_c.m[2][k] = column.b;
    }
    return wave(inverse(rgb_from_c) * std::array{rgb.r, rgb.g, rgb.b});
}

double distance(const RGBd& a, const RGBd& b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

// At the boundary of the gamut the linear answer is no reflectance: it takes more light away than there is, and gives
// light that was not there.
TEST(Uplift, LinearOneAtTheBoundaryIsNoReflectance) {
    const RgbUplift srgb(rgb_space("sRGB"));
    const PiecewiseLinearSpectrum red = linear_uplift(srgb, {1.0, 0.0, 0.0}),
                                  cyan = linear_uplift(srgb, {0.0, 1.0, 1.0});
    EXPECT_NEAR(*std::min_element(red.value.begin(), red.value.end()), -0.213, 0.001);
    EXPECT_NEAR(*std::max_element(cyan.value.begin(), cyan.value.end()), 1.213, 0.001);
    for (int corner = 0; corner < 8; ++corner) {
        const RGBd rgb{corner & 1 ? 1.0 : 0.0, corner & 2 ? 1.0 : 0.0, corner & 4 ? 1.0 : 0.0};
        const Spectrum ours = srgb.reflectance(rgb);
        for (int nm = 360; nm <= 830; ++nm) {
            const double value = eval(ours, nm);
            EXPECT_TRUE(value >= 0.0 && value <= 1.0) << corner << ", " << nm;
        }
        EXPECT_LT(distance(srgb.rgb_of(ours), rgb), 1e-6) << corner;
    }
}

// The sigmoid as published, 1/2 + x / (2 sqrt(1 + x^2)), takes two numbers that are nearly one from each other where
// reflectances are small: in single precision what is left has steps of 3e-8.
TEST(Uplift, SigmoidAsPublishedLosesTheDark) {
    const auto published = [](float x) { return 0.5f + x / (2.0f * std::sqrt(1.0f + x * x)); };
    const auto relative_error = [](float found, double value) {
        return std::abs(static_cast<double>(found) / value - 1.0);
    };
    double naive = 0.0, ours = 0.0;
    for (int i = 0; i < 1000; ++i) {
        const double value = 1e-6 * (1.0 + 1e-3 * i);
        const auto x = static_cast<float>(inverse_sigmoid(value));
        const double exact = sigmoid(static_cast<double>(x));
        naive = std::max(naive, relative_error(published(x), exact));
        ours = std::max(ours, relative_error(sigmoid(x), exact));
    }
    EXPECT_NEAR(naive, 0.034, 0.002);
    EXPECT_LT(ours, 1e-6);
    EXPECT_EQ(published(static_cast<float>(inverse_sigmoid(1e-8))), 0.0f);
    // And all the way from RGB: black and colours near it keep their ratios.
    const RgbUplift srgb(rgb_space("sRGB"));
    const RGBd dark{1e-6, 2e-6, 5e-7};
    EXPECT_LT(distance(srgb.rgb_of(srgb.reflectance(dark)), dark), 1e-12);
    EXPECT_EQ(eval(srgb.reflectance({}), 550.0), 0.0);
}

}  // namespace
}  // namespace emulsion::stability
