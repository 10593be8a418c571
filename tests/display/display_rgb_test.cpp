#include "display/display_rgb.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/named_value.h"
#include "core/random.h"

namespace emulsion {
namespace {

// The matrix of IEC 61966-2-1 as printed, to its four digits.
TEST(DisplayRgb, SrgbMatrixIsTheStandards) {
    constexpr std::array<std::array<double, 3>, 3> kPrinted = {
        {{3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}}};
    const Matrix3 matrix = rgb_from_xyz(SrgbDisplay{});
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            // The standard inverted a matrix that it had rounded to four digits.
            EXPECT_NEAR(matrix.m[row][column], kPrinted[row][column], 5e-4) << row << ", " << column;
        }
    }
}

TEST(DisplayRgb, WhiteIsOneOneOne) {
    for_each_alternative<Display>([](const auto& chosen) {
        const Display display = chosen;
        const XYZd white = white_xyz(display);
        EXPECT_EQ(white.y, 1.0);
        const RGBd rgb = display_rgb(rgb_from_xyz(display), white);
        EXPECT_NEAR(rgb.r, 1.0, 1e-14);
        EXPECT_NEAR(rgb.g, 1.0, 1e-14);
        EXPECT_NEAR(rgb.b, 1.0, 1e-14);
    });
}

TEST(DisplayRgb, SinglePrecisionIsWithinItsTolerance) {
    const Matrix3 matrix = rgb_from_xyz(Display{});
    Pcg32 random(30);
    std::vector<XYZ> xyz(100000);
    for (XYZ& p : xyz) {
        const float size = std::pow(10.0f, 20.0f * random.next_float() - 10.0f);
        p = size * XYZ{random.next_float() - 0.1f, random.next_float(), random.next_float() - 0.1f};
    }
    std::vector<RGB> rgb(xyz.size());
    display_rgb(matrix, xyz, rgb);
    for (std::size_t i = 0; i < xyz.size(); ++i) {
        const XYZd p{xyz[i].x, xyz[i].y, xyz[i].z};
        const RGBd exact = display_rgb(matrix, p);
        const double tolerance = 1e-6 * (std::abs(p.x) + std::abs(p.y) + std::abs(p.z));
        ASSERT_NEAR(rgb[i].r, exact.r, tolerance);
        ASSERT_NEAR(rgb[i].g, exact.g, tolerance);
        ASSERT_NEAR(rgb[i].b, exact.b, tolerance);
    }
}

TEST(DisplayRgb, LargeStaysFiniteAndNanStaysAlone) {
    const std::vector<XYZ> xyz{{0x1p119f, 0x1p119f, 0x1p119f},
                               {std::numeric_limits<float>::quiet_NaN(), 1.0f, 1.0f},
                               {0x1p119f, -0x1p119f, -0x1p119f}};
    std::vector<RGB> rgb(3);
    display_rgb(rgb_from_xyz(Display{}), xyz, rgb);
    for (const std::size_t i : {0, 2}) {
        EXPECT_TRUE(std::isfinite(rgb[i].r) && std::isfinite(rgb[i].g) && std::isfinite(rgb[i].b));
    }
    EXPECT_TRUE(std::isnan(rgb[1].r));
}

}  // namespace
}  // namespace emulsion
