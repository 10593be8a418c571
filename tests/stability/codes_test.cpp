// Codes of displays: curves that are steep at 0, and errors that are diffused.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "display/dither.h"
#include "display/transfer_encoder.h"

namespace emulsion {
namespace {

/// The codes of 8 bits that come out of linear values evenly spaced in [0, 1], to the nearest.
template <class Encode>
std::set<int> codes_that_come_out(const Encode& encode) {
    std::set<int> codes;
    for (int i = 0; i <= 1 << 20; ++i) {
        codes.insert(static_cast<int>(std::lround(255.0f * encode(static_cast<float>(i) * 0x1p-20f))));
    }
    return codes;
}

// x^(1/2.2) has an infinite slope at 0: from 0 to the first of 4095 steps it goes up to code 6.
TEST(PowerFunctions, AreNotTabulatedEvenlyNearZero) {
    std::vector<float> table(4096);
    for (std::size_t i = 0; i < table.size(); ++i) table[i] = std::pow(static_cast<float>(i) / 4095.0f, 1.0f / 2.2f);
    const std::set<int> naive =
        codes_that_come_out([&table](float x) { return table[static_cast<std::size_t>(std::lround(4095.0f * x))]; });
    std::vector<int> missing;
    for (int code = 0; code < 256; ++code) {
        if (!naive.contains(code)) missing.push_back(code);
    }
    EXPECT_EQ(missing, (std::vector<int>{1, 2, 3, 4, 5, 7, 9}));

    const TransferEncoder encoder(GammaTransfer{2.2});
    const auto ours = [&encoder](float x) {
        RGB rgb{x, x, x};
        encoder({&rgb, 1});
        return rgb.g;
    };
    EXPECT_EQ(codes_that_come_out(ours).size(), 256u);
    float worst = 0.0f;
    for (float x = 1.0f; x > 1e-30f; x *= 0.9f) {
        worst = std::max(worst, std::abs(ours(x) - static_cast<float>(encode(TransferFunction(GammaTransfer{2.2}),
                                                                             static_cast<double>(x)))));
    }
    EXPECT_LT(worst, 6.4e-8f);
}

Image<float> grey_picture(int width, int height, float grey) {
    Image<float> picture(width, height);
    for (float& p : picture.pixels()) p = grey;
    return picture;
}

double mean_of(const Image<std::uint16_t>& codes) {
    double sum = 0.0;
    for (const int code : codes.pixels()) sum += code;
    return sum / static_cast<double>(codes.pixels().size());
}

// Floyd and Steinberg's rule in bytes: shares of the error are whole codes, rounded toward 0, and those past the edges
// are dropped. Of small errors nothing is handed on, and greys between codes go where they are rounded to.
Image<std::uint16_t> diffuse_in_whole_codes(const Image<float>& picture) {
    Image<int> value(picture.width(), picture.height());
    for (std::size_t i = 0; i < value.pixels().size(); ++i) {
        value.pixels()[i] = static_cast<int>(std::lround(255.0f * picture.pixels()[i]));
    }
    Image<std::uint16_t> codes(picture.width(), picture.height());
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const int code = value(x, y) < 128 ? 0 : 255, error = value(x, y) - code;
            codes(x, y) = static_cast<std::uint16_t>(code / 255);
            const auto give = [&](int dx, int dy, int weight) {
                const bool is_inside = x + dx >= 0 && x + dx < picture.width() && y + dy < picture.height();
                if (is_inside) value(x + dx, y + dy) += error * weight / 16;
            };
            give(1, 0, 7), give(-1, 1, 3), give(0, 1, 5), give(1, 1, 1);
        }
    }
    return codes;
}

TEST(ErrorDiffusion, InWholeCodesDrifts) {
    const CodeScale one_bit{0, 1};
    constexpr float kGrey = 13.0f / 255.0f;
    const auto grey = static_cast<double>(kGrey);
    const Image<float> picture = grey_picture(256, 256, kGrey);
    EXPECT_NEAR(mean_of(diffuse_in_whole_codes(picture)) / grey, 0.854, 0.001);
    EXPECT_NEAR(mean_of(quantize(FloydSteinberg{}, picture.view(), one_bit, 1)), grey, 1.0 / (256 * 256));
    EXPECT_NEAR(mean_of(quantize(BlueNoise{}, picture.view(), one_bit, 1)), grey, 0.5 / (128 * 128));
}

/// How many of the dots of a dark grey have another one within two pixels: worms. Of dots that are spread evenly, each
/// with 1 / 0.05 = 20 pixels of its own, next to none.
double share_of_dots_in_worms(const Image<std::uint16_t>& codes) {
    std::int64_t dots = 0, touching = 0;
    for (int y = 100; y < 250; ++y) {
        for (int x = 3; x < 253; ++x) {
            if (codes(x, y) == 0) continue;
            ++dots;
            bool is_close = false;
            for (int dy = -2; dy <= 2; ++dy) {
                for (int dx = -2; dx <= 2; ++dx) is_close |= (dx != 0 || dy != 0) && codes(x + dx, y + dy) != 0;
            }
            touching += is_close ? 1 : 0;
        }
    }
    return static_cast<double>(touching) / static_cast<double>(dots);
}

TEST(ErrorDiffusion, MakesWormsOfDarkGreys) {
    const CodeScale one_bit{0, 1};
    const Image<float> picture = grey_picture(256, 256, 0.05f);
    EXPECT_NEAR(share_of_dots_in_worms(quantize(FloydSteinberg{}, picture.view(), one_bit, 1)), 0.469, 0.001);
    EXPECT_NEAR(share_of_dots_in_worms(quantize(FloydSteinberg{kSerpentineScan}, picture.view(), one_bit, 1)), 0.001,
                0.001);
    EXPECT_NEAR(share_of_dots_in_worms(quantize(BlueNoise{}, picture.view(), one_bit, 1)), 0.006, 0.001);
}

}  // namespace
}  // namespace emulsion
