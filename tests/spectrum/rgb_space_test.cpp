#include "spectrum/rgb_space.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "spectrum/chromaticity.h"
#include "spectrum/data_table.h"
#include "spectrum/normalised_rgb.h"

namespace emulsion {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(RgbSpace, MatrixOfBt709IsTheKnownOne) {
    constexpr Matrix3 kExpected{
        {{{0.412391, 0.357584, 0.180481}, {0.212639, 0.715169, 0.072192}, {0.019331, 0.119195, 0.950532}}}};
    for (const char* name : {"sRGB", "Rec709"}) {
        const Matrix3 matrix = xyz_from_rgb(rgb_space(name));
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(matrix.m[i][j], kExpected.m[i][j], 5e-7) << i << j;
        }
    }
}

TEST(RgbSpace, WhiteHasLuminanceOneAndInversesAgreeInEverySpace) {
    for (const std::string& name : data_table("rgb_colourspaces").row_names) {
        const RgbSpace& space = rgb_space(name);
        const auto xyz = xyz_from_rgb(space) * std::array<double, 3>{1.0, 1.0, 1.0};
        EXPECT_NEAR(xyz[1], 1.0, 1e-14) << name;
        EXPECT_NEAR(xyz[0], xyz_of(space.white).x, 1e-14) << name;
        EXPECT_NEAR(xyz[2], xyz_of(space.white).z, 1e-14) << name;
        const Matrix3 product = rgb_from_xyz(space) * xyz_from_rgb(space);
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(product.m[i][j], i == j ? 1.0 : 0.0, 1e-13) << name;
        }
    }
}

void expect_near(const Matrix3& matrix, const Matrix3& expected, double tolerance) {
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            EXPECT_NEAR(matrix.m[i][j], expected.m[i][j], tolerance) << "row " << i << ", column " << j;
        }
    }
}

constexpr Matrix3 kIdentity{{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}}};

TEST(RgbSpace, PrimariesHaveTheirChromaticities) {
    for (const std::string& name : data_table("rgb_colourspaces").row_names) {
        const RgbSpace& space = rgb_space(name);
        const Matrix3 matrix = xyz_from_rgb(space);
        const std::array<Chromaticity, 3> primary = {space.red, space.green, space.blue};
        for (std::size_t j = 0; j < 3; ++j) {
            const auto [x, y] = chromaticity_of(XYZd{matrix.m[0][j], matrix.m[1][j], matrix.m[2][j]});
            EXPECT_NEAR(x, primary[j].x, 1e-12) << name;
            EXPECT_NEAR(y, primary[j].y, 1e-12) << name;
        }
    }
}

// The matrix in print for NTSC, to three decimals. Its white is illuminant C, not D65.
TEST(RgbSpace, MatrixOfNtsc1953IsTheKnownOneWithIlluminantC) {
    constexpr Matrix3 kExpected{{{{0.607, 0.174, 0.200}, {0.299, 0.587, 0.114}, {0.000, 0.066, 1.116}}}};
    expect_near(xyz_from_rgb(rgb_space("NTSC_1953")), kExpected, 6e-4);
    RgbSpace d65 = rgb_space("NTSC_1953");
    d65.white = {0.3127, 0.329};
    EXPECT_GT(std::abs(xyz_from_rgb(d65).m[0][0] - kExpected.m[0][0]), 0.01);
}

// "Normalised" RGB is printed to four decimals, and differs from EBU primaries with E by up to 2.7e-3.
TEST(RgbSpace, NormalisedRgbIsNearEbuPrimariesWithIlluminantE) {
    RgbSpace ebu = rgb_space("PAL_SECAM");
    ebu.white = {1.0 / 3.0, 1.0 / 3.0};
    const Matrix3 matrix = xyz_from_rgb(ebu);
    EXPECT_NEAR(matrix.m[0][0], 0.5141, 5e-5);
    EXPECT_NEAR(matrix.m[0][1], 0.3239, 5e-5);
    EXPECT_NEAR(matrix.m[0][2], 0.1620, 5e-5);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            EXPECT_NEAR(kXyzFromNormalisedRgb.m[i][j], matrix.m[i][j], 2.7e-3) << i << j;
        }
    }
}

TEST(RgbSpace, NormalisedRgbOfOneIsXyzOfOne) {
    const XYZd white = xyz_from_normalised_rgb({1.0, 1.0, 1.0});
    EXPECT_NEAR(white.x, 1.0, 1e-15);
    EXPECT_NEAR(white.y, 1.0, 1e-15);
    EXPECT_NEAR(white.z, 1.0, 1e-15);
    EXPECT_NEAR(normalised_rgb_from_xyz({1.0, 1.0, 1.0}).g, 1.0, 1e-15);
}

// ITU-R BT.2087-0, 2.2: linear BT.709 to linear BT.2020, to four decimals.
TEST(RgbFromRgb, OfBt709InBt2020IsTheKnownOne) {
    constexpr Matrix3 kExpected{{{{0.6274, 0.3293, 0.0433}, {0.0691, 0.9195, 0.0114}, {0.0164, 0.0880, 0.8956}}}};
    expect_near(rgb_from_rgb(rgb_space("Rec709"), rgb_space("Rec2020")), kExpected, 5e-5);
}

TEST(RgbFromRgb, BackAndForthIsNothing) {
    const Matrix3 there = rgb_from_rgb(rgb_space("ROMM_ProPhoto"), rgb_space("DCI_P3"));
    expect_near(rgb_from_rgb(rgb_space("DCI_P3"), rgb_space("ROMM_ProPhoto")) * there, kIdentity, 1e-12);
    expect_near(rgb_from_rgb(rgb_space("sRGB"), rgb_space("Rec709")), kIdentity, 1e-14);
}

TEST(RgbFromRgb, KeepsTheWhiteOnlyWhenAdapted) {
    const RgbSpace &from = rgb_space("sRGB"), &to = rgb_space("DCI_P3");
    const std::array<double, 3> white = {1.0, 1.0, 1.0};
    EXPECT_GT(std::abs((rgb_from_rgb(from, to) * white)[2] - 1.0), 0.1);

    // The simplest of adaptations: X, Y and Z each scaled.
    const XYZd a = xyz_of(from.white), b = xyz_of(to.white);
    const Matrix3 scaling{{{{b.x / a.x, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, b.z / a.z}}}};
    for (const double component : rgb_from_rgb(from, to, scaling) * white) EXPECT_NEAR(component, 1.0, 1e-14);
    expect_near(rgb_from_rgb(from, to, kIdentity), rgb_from_rgb(from, to), 1e-15);
}

TEST(RgbSpace, NamesAreFoundInAnyCase) {
    EXPECT_EQ(rgb_space("SRGB"), rgb_space("srgb"));
    EXPECT_EQ(rgb_space("display_p3").name, "Display_P3");
    EXPECT_EQ(rgb_space("Display P3").name, "Display_P3");
}

TEST(RgbSpace, UnknownNamesListWhatExists) {
    EXPECT_THAT([] { (void)rgb_space("sRGV"); },
                ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("\"sRGV\""), HasSubstr("sRGB, Rec709, Rec2020"))));
}

TEST(RgbSpace, RefusesWhatHasNoMatrix) {
    RgbSpace line = rgb_space("sRGB");
    line.green = line.red;
    EXPECT_THAT([&] { (void)xyz_from_rgb(line); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("lie on one line, expected a triangle")));
    RgbSpace dark = rgb_space("sRGB");
    dark.white.y = 0.0;
    EXPECT_THAT([&] { (void)xyz_from_rgb(dark); }, ThrowsMessage<std::invalid_argument>(HasSubstr("(0.3127, 0)")));
}

}  // namespace
}  // namespace emulsion
