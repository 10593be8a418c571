// Pairs of pictures whose differences are known.

#include "compare/compare.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compare_fixture.h"
#include "core/text_file.h"
#include "spectrum/data_table.h"
#include "spectrum/pq.h"

namespace emulsion {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

// The published pairs as constant pictures of 1000 cd/m^2 at white. XYZ in single precision moves CIELAB by less than
// 1e-4: 500 / 3 * 2^-24 relative to the cube root.
TEST(Compare, ConstantPicturesOfTheSharmaPairsHaveThePublishedDifferences) {
    const DataTable pairs =
        parse_data_table("sharma_ciede2000_pairs",
                         read_text_file(std::string(EMULSION_SOURCE_DIR) + "/tests/data/sharma_ciede2000_pairs.csv"));
    const auto column = [&](const char* name, std::size_t row) { return pairs.column(name)[row]; };
    const std::size_t rows = pairs.column("L1").size();
    ASSERT_EQ(rows, 34U);
    for (std::size_t i = 0; i < rows; ++i) {
        const Lab first{column("L1", i), column("a1", i), column("b1", i)},
            second{column("L2", i), column("a2", i), column("b2", i)};
        const Comparison found =
            compare(constant(1000.0 * xyz_from_lab(first, d65())), constant(1000.0 * xyz_from_lab(second, d65())),
                    {.white_luminance_cdm2 = 1000.0});
        const double published = column("dE00", i);
        const double tolerance = i == 9 || i == 13 ? 0.06 : 2e-4;  // opposite hues: two values
        EXPECT_NEAR(found.ciede2000.mean, published, tolerance) << "pair " << i + 1;
        EXPECT_EQ(found.ciede2000.max, found.ciede2000.p50);
        EXPECT_NEAR(found.ciede2000.mean, found.ciede2000.max, 1e-12);
    }
}

// Greys of D65 have Ct = Cp = 0: 720 times the difference of PQ.
TEST(Compare, ItpOfGreysIsThatOfPq) {
    const Comparison found = compare(constant(50.0 * d65()), constant(200.0 * d65()), {.white_luminance_cdm2 = 406.0});
    const double expected = 720.0 * (encode(PqTransfer{}, 0.01) - encode(PqTransfer{}, 0.0025));
    EXPECT_NEAR(found.itp.mean, expected, 1e-3);
}

TEST(Compare, WhiteComesFromTheLogAverageOfA) {
    ComparedPicture a = constant(10.0 * d65(), 4, 1);
    a.xyz(0, 0) = narrowed(1000.0 * d65());
    a.xyz(1, 0) = {};                    // left out of the average
    a.xyz(2, 0) = {-1.0f, -2.0f, 0.0f};  // likewise
    const Comparison found = compare(a, constant(7.0 * d65(), 4, 1), {});
    EXPECT_NEAR(found.viewing.white_luminance_cdm2, 100.0 / 0.18, 1e-3);
    EXPECT_EQ(found.white_source, WhiteLuminanceSource::log_average_of_a);
    EXPECT_EQ(found.a, (PixelRuleCounts{.negative = 1, .above_white = 1}));
    EXPECT_EQ(found.b, PixelRuleCounts{});
}

TEST(Compare, EqualPicturesHaveNoDifference) {
    const ComparedPicture picture = random_picture(33, 21, 1);
    const Comparison found = compare(picture, picture, {});
    EXPECT_EQ(found.ciede2000.max, 0.0);
    EXPECT_EQ(found.itp.max, 0.0);
    EXPECT_EQ(found.squared.relative, 0.0);
    EXPECT_EQ(found.psnr_db, std::numeric_limits<double>::infinity());
}

TEST(Compare, NothingButPsnrDependsOnTheUnit) {
    const ComparedPicture a = random_picture(33, 21, 1), b = random_picture(33, 21, 2);
    ComparedPicture scaled_a = a, scaled_b = b;
    for (XYZ& pixel : scaled_a.xyz.pixels()) pixel = 0x1p-20f * pixel;
    for (XYZ& pixel : scaled_b.xyz.pixels()) pixel = 0x1p-20f * pixel;
    const Comparison here = compare(a, b, {}), there = compare(scaled_a, scaled_b, {});
    EXPECT_NEAR(here.ciede2000.mean, there.ciede2000.mean, 1e-9);
    EXPECT_NEAR(here.ciede2000.p99, there.ciede2000.p99, 1e-9);
    EXPECT_NEAR(here.itp.mean, there.itp.mean, 1e-8);
    EXPECT_NEAR(here.squared.relative / there.squared.relative, 1.0, 1e-9);
    EXPECT_NEAR(here.psnr_db, there.psnr_db, 0.01);  // tone mapping in single precision
}

TEST(Compare, BlackReferencesLeaveWhiteToTheOtherPicture) {
    const Comparison grey = compare(constant({}), constant(36.0 * d65()), {});
    EXPECT_EQ(grey.white_source, WhiteLuminanceSource::log_average_of_b);
    EXPECT_NEAR(grey.viewing.white_luminance_cdm2, 200.0, 1e-4);
    const Comparison both = compare(constant({}), constant({-1.0, -1.0, -1.0}), {});
    EXPECT_EQ(both.white_source, WhiteLuminanceSource::none);
    EXPECT_EQ(both.ciede2000.max, 0.0);  // nothing below nothing is to be seen
    EXPECT_EQ(both.b.negative, 35);
}

TEST(Compare, PixelsThatAreNotFiniteAreLeftOutAndCounted) {
    ComparedPicture a = random_picture(9, 6, 1), b = random_picture(9, 6, 2);
    a.xyz(3, 2).z = kNaN;
    b.xyz(3, 2).x = kNaN;
    b.xyz(5, 1).y = std::numeric_limits<float>::infinity();
    b.xyz(0, 4).x = -std::numeric_limits<float>::infinity();
    const Comparison found = compare(a, b, {});
    EXPECT_EQ(found.a.not_finite, 1);
    EXPECT_EQ(found.b.not_finite, 3);
    EXPECT_EQ(found.left_out, 3);
    EXPECT_EQ(found.first_left_out_px, std::pair(5, 1));
    EXPECT_EQ(found.ciede2000.pixels, 54 - 3);
    EXPECT_EQ(found.squared.pixels, 54 - 3);
    EXPECT_TRUE(std::isfinite(found.psnr_db));
    EXPECT_TRUE(std::isnan(found.ciede2000_pixels(3, 2)));
    EXPECT_THAT(
        [] {
            (void)compare(constant({kNaN, 1.0, 1.0}), constant({1.0, 1.0, 1.0}), {});
        },
        ThrowsMessage<std::invalid_argument>("no pixel is finite in both pictures"));
}

TEST(Compare, CropsAreComparedWhereBothHavePixels) {
    const ComparedPicture a = random_picture(12, 9, 1), b = random_picture(12, 9, 2);
    const Comparison found = compare(a, cropped(b, {4, 3, 9, 7}), {});
    EXPECT_EQ(found.window, (PixelBounds{4, 3, 9, 7}));
    const Comparison of_parts = compare(cropped(a, {4, 3, 9, 7}), cropped(b, {4, 3, 9, 7}), {});
    EXPECT_EQ(found.ciede2000, of_parts.ciede2000);
    EXPECT_GE(found.ciede2000.max_x, 4);
    EXPECT_GE(found.ciede2000.max_y, 3);
    EXPECT_EQ(found.ciede2000_pixels(found.ciede2000.max_x - 4, found.ciede2000.max_y - 3), found.ciede2000.max);
}

TEST(Compare, WhatDoesNotGoTogetherIsRefused) {
    const ComparedPicture a = constant(d65(), 8, 6);
    EXPECT_THAT(
        [&] { (void)compare(a, constant(d65(), 8, 7), {}); },
        ThrowsMessage<std::invalid_argument>("A is of a frame of 8x6 pixels, B of one of 8x7: expected the same"));
    EXPECT_THAT(
        [&] {
            (void)compare(cropped(a, {0, 0, 4, 6}), cropped(a, {4, 0, 8, 6}), {});
        },
        ThrowsMessage<std::invalid_argument>(HasSubstr("A has the pixels [0, 4) x [0, 6) of its frame, B "
                                                       "[4, 8) x [0, 6): expected some that both have")));
    ComparedPicture other = a;
    other.observer = "cie-1964-10deg";
    EXPECT_THAT(
        [&] { (void)compare(a, other, {}); },
        ThrowsMessage<std::invalid_argument>(HasSubstr("of the observer CIE 1931 2 degrees, B those of CIE 1964")));
    EXPECT_THROW((void)compare(a, a, {.white_luminance_cdm2 = -1.0}), std::invalid_argument);
    EXPECT_THROW((void)compare(a, a, {.white = Chromaticity{0.3, 0.0}}), std::invalid_argument);
    EXPECT_THROW((void)compare(a, a, {.threads = -1}), std::invalid_argument);
}

TEST(Compare, ThreadsChangeNoBit) {
    ComparedPicture a = random_picture(257, 131, 1), b = random_picture(257, 131, 2);
    for (ComparedPicture* picture : {&a, &b}) {
        picture->noise = KnownNoise::xyz;
        picture->standard_error = random_picture(257, 131, 3).xyz;
    }
    const auto with = [&](int threads) { return compare(a, b, {.threads = threads}); };
    const Comparison one = with(1), two = with(2), all = with(0);
    for (const Comparison* other : {&two, &all}) {
        EXPECT_EQ(one.ciede2000, other->ciede2000);
        EXPECT_EQ(one.itp, other->itp);
        EXPECT_EQ(one.squared, other->squared);
        EXPECT_EQ(one.psnr_db, other->psnr_db);
        EXPECT_EQ(one.ciede2000_pixels, other->ciede2000_pixels);
    }
}

}  // namespace
}  // namespace emulsion
