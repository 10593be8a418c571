#include "display/display.h"

#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/named_value.h"

namespace emulsion {
namespace {

std::string message_of(const Display& display) {
    try {
        validate(display);
        return "";
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

TEST(Display, DefaultsAreValid) {
    for_each_alternative<Display>([](const auto& display) { EXPECT_EQ(message_of(display), ""); });
}

// The chromaticities of the standards, red, green, blue and white.
TEST(Display, PrimariesAreThoseOfTheStandards) {
    constexpr Chromaticity kD65{0.3127, 0.329};
    const auto expect = [](const Display& display, const Chromaticity& red, const Chromaticity& green,
                           const Chromaticity& blue, const Chromaticity& white) {
        RgbSpace space = rgb_space(display);
        space.name.clear();
        EXPECT_EQ(space, (RgbSpace{"", red, green, blue, white})) << to_text(display);
    };
    expect(SrgbDisplay{}, {0.64, 0.33}, {0.3, 0.6}, {0.15, 0.06}, kD65);
    expect(DisplayP3{}, {0.68, 0.32}, {0.265, 0.69}, {0.15, 0.06}, kD65);
    expect(Rec2020Display{}, {0.708, 0.292}, {0.17, 0.797}, {0.131, 0.046}, kD65);
    expect(AdobeRgbDisplay{}, {0.64, 0.33}, {0.21, 0.71}, {0.15, 0.06}, kD65);
    expect(DciP3Display{}, {0.68, 0.32}, {0.265, 0.69}, {0.15, 0.06}, {0.314, 0.351});
    expect(CrtDisplay{}, {0.63, 0.34}, {0.31, 0.595}, {0.155, 0.07}, kD65);
    expect(Hdr10Display{}, {0.708, 0.292}, {0.17, 0.797}, {0.131, 0.046}, kD65);
    expect(HlgDisplay{}, {0.708, 0.292}, {0.17, 0.797}, {0.131, 0.046}, kD65);
    expect(CustomDisplay{}, {0.64, 0.33}, {0.3, 0.6}, {0.15, 0.06}, kD65);
}

TEST(Display, OwnTransferFunctionsAndPeaks) {
    EXPECT_EQ(own_transfer(SrgbDisplay{}), TransferFunction(SrgbTransfer{}));
    EXPECT_EQ(own_transfer(DisplayP3{}), TransferFunction(SrgbTransfer{}));
    EXPECT_EQ(own_transfer(Rec2020Display{}), TransferFunction(Bt1886Transfer{}));
    EXPECT_EQ(own_transfer(Rec2020Display{300.0, 2.0}), TransferFunction(Bt1886Transfer{2.0, 300.0}));
    EXPECT_EQ(own_transfer(AdobeRgbDisplay{}), TransferFunction(AdobeRgbTransfer{}));
    EXPECT_EQ(own_transfer(DciP3Display{}), TransferFunction(GammaTransfer{2.6}));
    EXPECT_EQ(own_transfer(CrtDisplay{}), TransferFunction(GammaTransfer{2.5}));
    EXPECT_EQ(own_transfer(Hdr10Display{}), TransferFunction(PqTransfer{}));
    EXPECT_EQ(own_transfer(HlgDisplay{}), TransferFunction(HlgTransfer{}));
    EXPECT_EQ(own_transfer(CustomDisplay{}), TransferFunction(SrgbTransfer{}));
    EXPECT_EQ(light_of(Hdr10Display{}), (DisplayLight{1000.0, 0.0, 0.0}));
    EXPECT_EQ(light_of(DciP3Display{}), (DisplayLight{48.0, 0.0, 0.0}));
    EXPECT_EQ(light_of(CrtDisplay{100.0, 0.1, 2.0}), (DisplayLight{100.0, 0.1, 2.0}));
}

TEST(Display, SignalScaleIsExactlyNothingByDefault) {
    EXPECT_EQ(signal_scale({80.0, 0.0, 0.0}), SignalScale{});
    EXPECT_EQ(signal_scale({100.0, 1.0, 3.0}), (SignalScale{103.0 / 99.0, 4.0 / 99.0}));
}

TEST(Display, PrimariesThatMakeNoTriangleAreRefused) {
    CustomDisplay display;
    display.gx = 0.4, display.gy = 0.2;
    display.rx = 0.65, display.ry = 0.34;  // (0.15, 0.06), (0.4, 0.2) and (0.65, 0.34): exactly halfway
    EXPECT_THAT(message_of(display), testing::HasSubstr("must not lie on one line"));
    display = {};
    display.gx = display.rx, display.gy = display.ry;
    EXPECT_EQ(message_of(display),
              "display custom: primaries (0.64, 0.33), (0.64, 0.33), (0.15, 0.06): must not lie on one line");
}

TEST(Display, AWhiteThatIsNotInsideIsRefused) {
    CustomDisplay display;
    display.wx = 0.7;
    EXPECT_EQ(message_of(display),
              "display custom: white (0.7, 0.329): must lie inside the triangle of the primaries (0.64, 0.33), (0.3, "
              "0.6), (0.15, 0.06), 0.001 or more from its sides");
    display.wx = 0.64, display.wy = 0.33;
    EXPECT_THAT(message_of(display), testing::HasSubstr("must lie inside the triangle"));
}

// Inside of a triangle, which may be larger than the spectral locus: Oklab's L cones don't respond to it.
TEST(Display, AWhiteThatNoLightHasIsRefused) {
    const CustomDisplay display{.bx = 0.0, .by = 0.0, .wx = 0.05, .wy = 0.05};
    EXPECT_EQ(message_of(display),
              "display custom: wx = 0.05, wy = 0.05: a white that no light has, expected one that all three kinds of "
              "cones see");
}

TEST(Display, ParametersOutOfRangeAreNamed) {
    EXPECT_EQ(message_of(SrgbDisplay{1.0}), "display srgb: peak = 1: must be in [10, 10000]");
    EXPECT_EQ(message_of(HlgDisplay{4000.0}), "display hlg: peak = 4000: must be in [400, 2000]");
    EXPECT_EQ(message_of(SrgbDisplay{80.0, -1.0}), "display srgb: black = -1: must be in [0, 5]");
    EXPECT_EQ(message_of(CustomDisplay{.rx = 1.5}), "display custom: rx = 1.5: must be in [0, 1]");
}

}  // namespace
}  // namespace emulsion
