#include "spectrum/ycbcr.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace emulsion {
namespace {

struct Bar {
    RGBd rgb;
    std::array<int, 3> code;  // Y', Cb, Cr
};

void expect_codes(const LumaWeights& weights, const std::array<Bar, 8>& bars) {
    for (const Bar& bar : bars) {
        const Ycbcr ycbcr = ycbcr_from_rgb(weights, kNarrowRange, bar.rgb);
        EXPECT_EQ(std::lround(ycbcr.luma), bar.code[0]);
        EXPECT_EQ(std::lround(ycbcr.cb), bar.code[1]);
        EXPECT_EQ(std::lround(ycbcr.cr), bar.code[2]);
    }
}

// 100% colour bars, as published for 8 bits (Poynton, Digital Video and HD, 2nd ed., tables of BT.601 and BT.709 bars).
TEST(Ycbcr, OfColourBarsInNarrowBt601) {
    expect_codes(kBt601Luma,
                 {Bar{{1, 1, 1}, {235, 128, 128}}, Bar{{1, 1, 0}, {210, 16, 146}}, Bar{{0, 1, 1}, {170, 166, 16}},
                  Bar{{0, 1, 0}, {145, 54, 34}}, Bar{{1, 0, 1}, {106, 202, 222}}, Bar{{1, 0, 0}, {81, 90, 240}},
                  Bar{{0, 0, 1}, {41, 240, 110}}, Bar{{0, 0, 0}, {16, 128, 128}}});
}

TEST(Ycbcr, OfColourBarsInNarrowBt709) {
    expect_codes(kBt709Luma,
                 {Bar{{1, 1, 1}, {235, 128, 128}}, Bar{{1, 1, 0}, {219, 16, 138}}, Bar{{0, 1, 1}, {188, 154, 16}},
                  Bar{{0, 1, 0}, {173, 42, 26}}, Bar{{1, 0, 1}, {78, 214, 230}}, Bar{{1, 0, 0}, {63, 102, 240}},
                  Bar{{0, 0, 1}, {32, 240, 118}}, Bar{{0, 0, 0}, {16, 128, 128}}});
}

// The divisors that the standards print are 2 (1 - weight): 1.772, 1.402; 1.8556, 1.5748; 1.8814, 1.4746.
TEST(Ycbcr, HasThePrintedDivisors) {
    struct Printed {
        LumaWeights weights;
        double of_cb, of_cr;
    };
    for (const Printed& printed : {Printed{kBt601Luma, 1.772, 1.402}, Printed{kBt709Luma, 1.8556, 1.5748},
                                   Printed{kBt2020Luma, 1.8814, 1.4746}}) {
        const RGBd rgb = {0.2, 0.7, 0.4};
        const double luma = printed.weights.kr * 0.2 + printed.weights.kg() * 0.7 + printed.weights.kb * 0.4;
        const Ycbcr ycbcr = ycbcr_from_rgb(printed.weights, kFullRange, rgb);
        EXPECT_NEAR(ycbcr.luma, luma, 1e-15);
        EXPECT_NEAR(ycbcr.cb, (0.4 - luma) / printed.of_cb + 0.5, 1e-15);
        EXPECT_NEAR(ycbcr.cr, (0.2 - luma) / printed.of_cr + 0.5, 1e-15);
    }
}

TEST(Luma, GreenHasThePrintedWeight) {
    EXPECT_NEAR(kBt601Luma.kg(), 0.587, 1e-15);
    EXPECT_NEAR(kBt709Luma.kg(), 0.7152, 1e-15);
    EXPECT_NEAR(kBt2020Luma.kg(), 0.6780, 1e-15);
}

// 10-bit codes are four times the 8-bit scale: 64 to 940, and 64 to 960.
TEST(Ycbcr, NarrowRangeScalesToTenBits) {
    EXPECT_NEAR(4.0 * ycbcr_from_rgb(kBt2020Luma, kNarrowRange, {1.0, 1.0, 1.0}).luma, 940.0, 1e-12);
    EXPECT_NEAR(4.0 * ycbcr_from_rgb(kBt2020Luma, kNarrowRange, {0.0, 0.0, 1.0}).cb, 960.0, 1e-12);
    EXPECT_NEAR(4.0 * ycbcr_from_rgb(kBt2020Luma, kNarrowRange, {0.0, 1.0, 1.0}).cr, 64.0, 1e-12);
}

TEST(Ycbcr, TakesValuesOutsideTheCube) {
    for (const YcbcrRange& range : {kFullRange, kNarrowRange}) {
        const RGBd rgb = {-0.5, 1.5, 3.0},
                   back = rgb_from_ycbcr(kBt709Luma, range, ycbcr_from_rgb(kBt709Luma, range, rgb));
        EXPECT_NEAR(back.r, rgb.r, 2e-15);
        EXPECT_NEAR(back.g, rgb.g, 2e-15);
        EXPECT_NEAR(back.b, rgb.b, 2e-15);
    }
}

}  // namespace
}  // namespace emulsion
