#include "spectrum/rgb_space.h"

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "spectrum/data_table.h"

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

TEST(RgbSpace, NamesAreFoundInAnyCase) {
    EXPECT_EQ(rgb_space("SRGB"), rgb_space("srgb"));
    EXPECT_EQ(rgb_space("display_p3").name, "Display_P3");
}

TEST(RgbSpace, UnknownNamesListWhatExists) {
    EXPECT_THAT([] { (void)rgb_space("sRGV"); },
                ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("\"sRGV\""), HasSubstr("sRGB, Rec709, Rec2020"))));
}

TEST(RgbSpace, RefusesWhatHasNoMatrix) {
    RgbSpace line = rgb_space("sRGB");
    line.green = line.red;
    EXPECT_THROW((void)xyz_from_rgb(line), std::invalid_argument);
    RgbSpace dark = rgb_space("sRGB");
    dark.white.y = 0.0;
    EXPECT_THAT([&] { (void)xyz_from_rgb(dark); }, ThrowsMessage<std::invalid_argument>(HasSubstr("(0.3127, 0)")));
}

}  // namespace
}  // namespace emulsion
