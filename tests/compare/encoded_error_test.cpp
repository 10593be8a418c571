#include "compare/encoded_error.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "compare_fixture.h"
#include "spectrum/srgb_transfer.h"

namespace emulsion {
namespace {

/// 100 cd/m^2 are white; linear codes.
Pipeline linear_pipeline() { return {.tone_mapper = FixedWhite{}, .transfer = LinearTransfer{}}; }

double psnr(const ComparedPicture& a, const ComparedPicture& b, const Pipeline& pipeline = {}) {
    return encoded_psnr_db(a.xyz, b.xyz, pipeline, 0);
}

TEST(EncodedPsnr, IsThatOfTheEncodedNumbers) {
    const ComparedPicture a = constant(50.0 * d65()), b = constant(60.0 * d65());
    EXPECT_NEAR(psnr(a, b, linear_pipeline()), 20.0, 1e-3);  // 0.1 of the peak
    Pipeline srgb = linear_pipeline();
    srgb.transfer = SrgbTransfer{};
    const double difference = encode(SrgbTransfer{}, 0.6) - encode(SrgbTransfer{}, 0.5);
    EXPECT_NEAR(psnr(a, b, srgb), -20.0 * std::log10(difference), 1e-3);
}

// Half of the pixels differ: 3.01 dB more.
TEST(EncodedPsnr, IsOfTheMeanOverAllPixels) {
    const ComparedPicture a = constant(50.0 * d65(), 8, 4);
    ComparedPicture b = a;
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 8; x += 2) b.xyz(x, y) = narrowed(60.0 * d65());
    }
    EXPECT_NEAR(psnr(a, b, linear_pipeline()), 20.0 + 10.0 * std::log10(2.0), 1e-3);
}

TEST(EncodedPsnr, NeitherDitheringNorLightAboveThePeakIsADifference) {
    const ComparedPicture a = constant(500.0 * d65()), b = constant(900.0 * d65());
    Pipeline unmapped = linear_pipeline();
    unmapped.gamut = GamutNone{};
    EXPECT_EQ(psnr(a, b, unmapped), std::numeric_limits<double>::infinity());
    Pipeline coarse = linear_pipeline();
    coarse.bits = 1;
    EXPECT_NEAR(psnr(constant(50.0 * d65()), constant(60.0 * d65()), coarse), 20.0, 1e-3);
}

// Each by its own statistics the two would be equal.
TEST(EncodedPsnr, ABrighterPictureIsAnotherOne) {
    const ComparedPicture a = random_picture(40, 30, 1);
    ComparedPicture b = a;
    for (XYZ& pixel : b.xyz.pixels()) pixel = 1.1f * pixel;
    EXPECT_LT(psnr(a, b), 45.0);
    EXPECT_GT(psnr(a, b), 20.0);
}

TEST(EncodedPsnr, WhatDoesNotGoTogetherIsRefused) {
    EXPECT_THROW((void)psnr(constant(d65(), 2, 2), constant(d65(), 2, 3)), std::invalid_argument);
    EXPECT_THROW((void)psnr(constant(d65()), constant(d65()), {.bits = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace emulsion
