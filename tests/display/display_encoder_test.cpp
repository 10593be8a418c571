#include "display/display_encoder.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "core/named_value.h"
#include "core/random.h"
#include "display/display_gamut.h"

namespace emulsion {
namespace {

/// The defaults, and dim ones in lit rooms.
std::vector<Display> all_displays() {
    std::vector<Display> all;
    for_each_alternative<Display>([&](const auto& display) {
        all.emplace_back(display);
        auto lit = display;
        lit.peak_cdm2 = 500.0, lit.black_cdm2 = 0.7, lit.flare_cdm2 = 5.0;
        all.emplace_back(lit);
    });
    return all;
}

TEST(DisplayEncoder, IsWithinItsToleranceOfTheTwin) {
    Pcg32 random(60);
    std::vector<RGB> signal{{0.0f, 0.0f, 0.0f}, {1.0f, 1.0f, 1.0f}, {0.0f, 0.0f, 1.0f}, {1e-30f, 1e-38f, 1e-40f}};
    for (int i = 0; i < 3000; ++i) {
        const float size = std::pow(random.next_float(), 4.0f);
        signal.push_back({size * random.next_float(), size * random.next_float(), size * random.next_float()});
    }
    for (const Display& display : all_displays()) {
        const TransferFunction transfer = own_transfer(display);
        std::vector<RGB> encoded = signal;
        (void)DisplayEncoder(display, transfer)(encoded);
        // 6.4e-8 of the table; HLG has 2e-7 relative of its argument on top, which its square root halves, and the
        // lift, which takes up to 0.2 off the range of codes.
        for (std::size_t i = 0; i < signal.size(); ++i) {
            const RGBd exact = encode_signal(display, transfer, {signal[i].r, signal[i].g, signal[i].b});
            ASSERT_NEAR(encoded[i].r, exact.r, 2.5e-7) << to_text(display) << ' ' << i;
            ASSERT_NEAR(encoded[i].g, exact.g, 2.5e-7) << to_text(display) << ' ' << i;
            ASSERT_NEAR(encoded[i].b, exact.b, 2.5e-7) << to_text(display) << ' ' << i;
        }
    }
}

// SMPTE ST 2084: 100 cd/m^2 has code 0.5080784, 1000 cd/m^2 0.7518271 of the full range.
TEST(DisplayEncoder, PqCodesAreLuminances) {
    EXPECT_NEAR(encode_signal(Hdr10Display{}, PqTransfer{}, {0.1, 0.1, 1.0}).r, 0.5080784, 1e-7);
    EXPECT_NEAR(encode_signal(Hdr10Display{}, PqTransfer{}, {0.1, 0.1, 1.0}).b, 0.7518271, 1e-7);
    EXPECT_NEAR(encode_signal(SrgbDisplay{100.0}, PqTransfer{}, {1.0, 1.0, 1.0}).g, 0.5080784, 1e-7);
    // A black of its own is in the code.
    EXPECT_EQ(encode_signal(Hdr10Display{1000.0, 0.5}, PqTransfer{}, {}).g, encode(PqTransfer{}, 0.5 / 10000.0));
    EXPECT_EQ(pq_linear({10000.0}, 0.25), 0.25);
}

// BT.2100-2: 1.2 at 1000 cd/m^2. Decoding by its formulas, OETF^-1 and OOTF, shows the signal again.
TEST(DisplayEncoder, HlgUndoesTheSystemGamma) {
    EXPECT_EQ(hlg_system_gamma(1000.0), 1.2);
    EXPECT_NEAR(hlg_system_gamma(2000.0), 1.3264, 1e-4);
    const RGBd luminance{0.2627, 0.6780, 0.0593};
    EXPECT_NEAR(display_gamut(HlgDisplay{}).luminance.g, luminance.g, 5e-5);
    for (const RGBd& signal : {RGBd{1.0, 1.0, 1.0}, {0.2, 0.5, 0.1}, {0.7, 0.1, 0.3}, {1e-4, 2e-4, 3e-4}}) {
        const RGBd code = encode_signal(HlgDisplay{}, HlgTransfer{}, signal);
        const RGBd scene{decode(HlgTransfer{}, code.r), decode(HlgTransfer{}, code.g), decode(HlgTransfer{}, code.b)};
        const double scene_luminance = luminance.r * scene.r + luminance.g * scene.g + luminance.b * scene.b;
        const RGBd shown = std::pow(scene_luminance, 0.2) * scene;
        EXPECT_NEAR(shown.r, signal.r, 1e-5 * signal.r);
        EXPECT_NEAR(shown.g, signal.g, 1e-5 * signal.g);
        EXPECT_NEAR(shown.b, signal.b, 1e-5 * signal.b);
    }
}

/// What a display for HLG shows for codes, 1 for its white: BT.2100-2, table 5, with its black lift.
RGBd hlg_shown(double gamma, double black, const RGBd& code) {
    const double lift = std::sqrt(3.0 * std::pow(black, 1.0 / gamma));
    const auto scene_of = [&](double c) { return decode(HlgTransfer{}, (1.0 - lift) * c + lift); };
    const RGBd scene{scene_of(code.r), scene_of(code.g), scene_of(code.b)};
    const double luminance = 0.2627 * scene.r + 0.6780 * scene.g + 0.0593 * scene.b;
    return std::pow(luminance, gamma - 1.0) * scene;
}

// A full blue would take 0.0593^(-1/6) = 1.60 times the light that HLG encodes. It is shown as less of it with some
// grey, at its luminance.
TEST(DisplayEncoder, HlgKeepsTheLuminanceOfBrightSaturatedColours) {
    EXPECT_NEAR(std::pow(0.0593, -1.0 / 6.0), 1.60, 0.005);
    for (const RGBd& signal : {RGBd{0.0, 0.0, 1.0}, {1.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, {0.9, 0.2, 1.0}}) {
        const RGBd code = encode_signal(HlgDisplay{}, HlgTransfer{}, signal);
        EXPECT_NEAR(std::max(code.r, code.b), 1.0, 1e-8);
        const RGBd shown = hlg_shown(1.2, 0.0, code);
        EXPECT_NEAR(0.2627 * shown.r + 0.6780 * shown.g + 0.0593 * shown.b,
                    0.2627 * signal.r + 0.6780 * signal.g + 0.0593 * signal.b, 1e-4);
    }
    EXPECT_LT(encode_signal(HlgDisplay{}, HlgTransfer{}, {0.0, 0.0, 0.5}).b, 1.0);
}

TEST(DisplayEncoder, CountsWhatHlgHasNoCodeFor) {
    std::vector<RGB> pixels{{0.0f, 0.0f, 1.0f}, {1.0f, 1.0f, 1.0f}, {0.0f, 0.0f, 0.5f}, {1.0f, 0.0f, 1.0f}, {}};
    EXPECT_EQ(DisplayEncoder(HlgDisplay{}, HlgTransfer{})(pixels), 2);
    EXPECT_EQ(DisplayEncoder(HlgDisplay{}, SrgbTransfer{})(pixels), 0);
    EXPECT_EQ(DisplayEncoder(Hdr10Display{}, PqTransfer{})(pixels), 0);
}

// A black of its own: the display lifts all codes, so that 0 shows it. Colours whose light in the scene is below that
// lift aren't shown; greys and moderate colours are.
TEST(DisplayEncoder, HlgUndoesTheLiftOfADisplaysBlack) {
    const HlgDisplay display{1000.0, 1.0};
    EXPECT_NEAR(encode_signal(display, HlgTransfer{}, {}).g, 0.0, 1e-15);
    EXPECT_NEAR(hlg_shown(1.2, 0.001, {}).g, 0.001, 1e-9);
    for (const RGBd& signal : {RGBd{1.0, 1.0, 1.0}, {0.2, 0.5, 0.1}, {1e-3, 1e-3, 1e-3}, {0.03, 0.02, 0.01}, {}}) {
        const RGBd shown = hlg_shown(1.2, 0.001, encode_signal(display, HlgTransfer{}, signal));
        EXPECT_NEAR(shown.r, 0.001 + 0.999 * signal.r, 1e-5);
        EXPECT_NEAR(shown.g, 0.001 + 0.999 * signal.g, 1e-5);
        EXPECT_NEAR(shown.b, 0.001 + 0.999 * signal.b, 1e-5);
    }
}

// BT.1886, annex 1: L = a max(V + b, 0)^2.4, in cd/m^2, of a display that has a black.
double bt1886_cdm2(double white, double black, double code) {
    const double root = std::pow(white, 1.0 / 2.4) - std::pow(black, 1.0 / 2.4);
    return std::pow(root, 2.4) * std::pow(std::max(code + std::pow(black, 1.0 / 2.4) / root, 0.0), 2.4);
}

TEST(DisplayEncoder, Bt1886ShowsTheSignalOnADisplayWithABlack) {
    const Rec2020Display display{100.0, 0.1};
    for (const double s : {0.0, 1e-4, 0.002, 0.05, 0.5, 1.0}) {
        const double wanted_cdm2 = 0.1 + s * 99.9;
        const double code = encode_signal(display, own_transfer(display), {s, s, s}).g;
        EXPECT_NEAR(bt1886_cdm2(100.0, 0.1, code), wanted_cdm2, 1e-12 * wanted_cdm2) << s;
        // The same display, described by its transfer function as well.
        EXPECT_EQ(encode_signal(display, Bt1886Transfer{0.1, 100.0}, {s, s, s}).g, code);
    }
    EXPECT_EQ(encode_signal(display, own_transfer(display), {}).g, 0.0);
    EXPECT_EQ(encode_signal(display, own_transfer(display), {1.0, 1.0, 1.0}).g, 1.0);
    // A transfer function that tells of a brighter black than the display does: what is darker is code 0.
    EXPECT_EQ(encode_signal(SrgbDisplay{}, Bt1886Transfer{0.1, 100.0}, {0.0005, 0.0, 0.5}).r, 0.0);
    std::vector<RGB> pixels{{0.0f, 0.0005f, 1.0f}};
    (void)DisplayEncoder(SrgbDisplay{}, Bt1886Transfer{0.1, 100.0})(pixels);
    EXPECT_EQ(pixels[0], (RGB{0.0f, 0.0f, 1.0f}));
}

// On other displays HLG is the camera's curve of the signal.
TEST(DisplayEncoder, HlgHasASystemGammaOnItsOwnDisplayOnly) {
    EXPECT_EQ(encode_signal(SrgbDisplay{}, HlgTransfer{}, {0.2, 0.3, 0.4}).r, encode(HlgTransfer{}, 0.2));
    EXPECT_EQ(encode_signal(HlgDisplay{}, SrgbTransfer{}, {0.2, 0.3, 0.4}).r, encode(SrgbTransfer{}, 0.2));
}

}  // namespace
}  // namespace emulsion
