#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "dither_fixture.h"
#include "power_spectrum.h"

namespace emulsion {
namespace {

constexpr std::int64_t kUnitsPerCode = 65536;

/// Sum of the values, each rounded to a unit of 2^-16 code, less the sum of the codes: what was lost. In units.
BasicRGB<std::int64_t> lost_units(const Image<RGB>& encoded, const Image<CodeRGB>& codes) {
    const auto lost = [](float value, int code) {
        return std::llround(static_cast<double>(value) * 255.0 * kUnitsPerCode) - code * kUnitsPerCode;
    };
    BasicRGB<std::int64_t> sum;
    for (std::size_t i = 0; i < encoded.pixels().size(); ++i) {
        const RGB& value = encoded.pixels()[i];
        const CodeRGB& code = codes.pixels()[i];
        sum = sum + BasicRGB<std::int64_t>{lost(value.r, code.r), lost(value.g, code.g), lost(value.b, code.b)};
    }
    return sum;
}

// Codes of 8 bits are those of the first implementation, which took every error in 64 bits.
TEST(FloydSteinberg, CodesHaveNotChanged) {
    std::uint64_t hash = 0;
    for (const auto& [width, height] :
         {std::pair{1, 1}, {1, 50}, {50, 1}, {2, 31}, {3, 2}, {5, 5}, {61, 47}, {640, 480}}) {
        Pcg32 random(60);
        Image<RGB> picture(width, height);
        for (RGB& p : picture.pixels()) {
            p.r = random.next_float();
            p.g = 0.25f * random.next_float();
            p.b = 1.1f * random.next_float();
        }
        for (int x = 0; x < width; ++x) picture(x, height / 2) = {1.0f, 0.0f, 0.5f};
        const Image<CodeRGB> codes = quantize(FloydSteinberg{}, picture.view(), {}, 1);
        for (const CodeRGB& c : codes.pixels()) {
            hash = hash_combine(hash, (std::uint64_t{c.r} << 32u) | (std::uint64_t{c.g} << 16u) | c.b);
        }
    }
    EXPECT_EQ(hash, 0xe40024bc5034d2c9u);
}

/// Calls visitor(dither) for every kernel that keeps the mean, in every scan order.
template <class Visitor>
void for_each_that_keeps_the_mean(const Visitor& visitor) {
    for (const ParameterWord& scan : kScanOrders) {
        visitor(Dither(FloydSteinberg{scan.value}));
        visitor(Dither(Jarvis{scan.value}));
        visitor(Dither(Stucki{scan.value}));
        visitor(Dither(Sierra{scan.value}));
    }
}

TEST(ErrorDiffusion, LosesTheErrorOfTheLastPixelAndNothingElse) {
    for_each_that_keeps_the_mean([](const Dither& dither) {
        SCOPED_TRACE(to_text(dither));
        for (const auto& [width, height] :
             {std::pair{1, 1}, {1, 97}, {97, 1}, {2, 2}, {2, 53}, {3, 2}, {53, 3}, {101, 103}}) {
            const Image<RGB> picture = random_picture(width, height, 51);
            const auto lost = lost_units(picture, quantize(dither, picture.view(), {}, 1));
            for (const std::int64_t units : {lost.r, lost.g, lost.b}) {
                EXPECT_LE(std::abs(units), kUnitsPerCode) << width << "x" << height;
            }
        }
        // With last pixels that can take any error, none beyond half a code is lost. A Hilbert curve ends top right.
        Image<RGB> picture = random_picture(64, 64, 52);
        for (int y = 0; y < 64; ++y) picture(63, y) = {0.5f, 0.5f, 0.5f};
        const auto lost = lost_units(picture, quantize(dither, picture.view(), {}, 1));
        for (const std::int64_t units : {lost.r, lost.g, lost.b}) EXPECT_LE(std::abs(units), kUnitsPerCode / 2);
    });
}

/// Mean of the first rows of a constant of one bit, 256 pixels wide, less its value.
double error_of_rows(const Dither& dither, float grey, int rows) {
    const CodeScale one_bit{0, 1};
    const Image<std::uint16_t> codes = quantize(dither, constant_grey(256, 256, grey).view(), one_bit, 1);
    std::int64_t sum = 0;
    for (int y = 0; y < rows; ++y) {
        for (const int code : codes.row(y)) sum += code;
    }
    return static_cast<double>(sum) / (256.0 * rows) - static_cast<double>(grey);
}

// A quarter of each error is lost: near the ends nearly all of the grey, in the middle nothing on the whole.
TEST(Atkinson, MeanIsOff) {
    EXPECT_NEAR(error_of_rows(Atkinson{}, 0.1f, 256), -0.098, 0.001);
    EXPECT_NEAR(error_of_rows(Atkinson{}, 0.2f, 256), -0.067, 0.001);
    EXPECT_NEAR(error_of_rows(Atkinson{}, 0.4f, 256), -0.022, 0.001);
    EXPECT_NEAR(error_of_rows(Atkinson{}, 0.5f, 256), 0.0, 0.001);
    EXPECT_NEAR(error_of_rows(Atkinson{}, 0.8f, 256), 0.067, 0.001);
}

// Start-up: in dark greys the first dots come late. Of a grey of 0.05 in one bit, the first 16 rows lack a quarter by
// Floyd and Steinberg, more than half by Jarvis; along a Hilbert curve, and by blue noise, they lack nothing.
TEST(ErrorDiffusion, StartsUpLateInTheDark) {
    EXPECT_NEAR(error_of_rows(FloydSteinberg{}, 0.05f, 16), -0.012, 0.001);
    EXPECT_NEAR(error_of_rows(FloydSteinberg{kSerpentineScan}, 0.05f, 16), -0.012, 0.001);
    EXPECT_NEAR(error_of_rows(Jarvis{}, 0.05f, 16), -0.029, 0.001);
    EXPECT_NEAR(error_of_rows(FloydSteinberg{kHilbertScan}, 0.05f, 16), 0.0, 0.001);
    EXPECT_NEAR(error_of_rows(Jarvis{kHilbertScan}, 0.05f, 16), 0.0, 0.001);
    EXPECT_NEAR(error_of_rows(BlueNoise{}, 0.05f, 16), 0.0, 0.003);
}

// Regular textures: the strongest frequency's share of all power, at the greys where Floyd and Steinberg's method is
// known for them. It makes a chessboard of 1/2; other orders only make less of it. Blue noise has none.
TEST(ErrorDiffusion, HasTexturesAtSimpleFractions) {
    const auto peak = [](const Dither& dither, float grey) {
        return peak_share(quantize(dither, constant_grey(128, 128, grey).view(), {0, 1}, 1));
    };
    EXPECT_NEAR(peak(FloydSteinberg{}, 0.5f), 1.0, 1e-9);
    EXPECT_NEAR(peak(FloydSteinberg{}, 1.0f / 3.0f), 0.060, 0.005);
    EXPECT_NEAR(peak(FloydSteinberg{kSerpentineScan}, 1.0f / 3.0f), 0.032, 0.005);
    EXPECT_NEAR(peak(FloydSteinberg{kHilbertScan}, 0.5f), 0.095, 0.005);
    EXPECT_NEAR(peak(FloydSteinberg{kHilbertScan}, 1.0f / 3.0f), 0.078, 0.005);
    EXPECT_LT(peak(BlueNoise{}, 0.5f), 0.001);
    EXPECT_LT(peak(BlueNoise{}, 1.0f / 3.0f), 0.001);
}

/// The rule as it is written, in double precision: each error is divided among the neighbours that exist.
Image<CodeRGB> diffuse_plainly(const Image<RGB>& picture) {
    struct Neighbour {
        int dx, dy, weight;
    };
    constexpr std::array<Neighbour, 4> kNeighbours = {{{1, 0, 7}, {-1, 1, 3}, {0, 1, 5}, {1, 1, 1}}};
    Image<double> values(picture.width(), picture.height());
    Image<CodeRGB> codes(picture.width(), picture.height());
    for (std::size_t i = 0; i < values.pixels().size(); ++i) values.pixels()[i] = 255.0 * picture.pixels()[i].g;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const double code = std::clamp(std::floor(values(x, y) + 0.5), 0.0, 255.0);
            codes(x, y).g = static_cast<std::uint8_t>(code);
            std::vector<Neighbour> inside;
            for (const Neighbour& n : kNeighbours) {
                if (x + n.dx >= 0 && x + n.dx < picture.width() && y + n.dy < picture.height()) inside.push_back(n);
            }
            int total = 0;
            for (const Neighbour& n : inside) total += n.weight;
            for (const Neighbour& n : inside) values(x + n.dx, y + n.dy) += (values(x, y) - code) * n.weight / total;
        }
    }
    return codes;
}

// Units of 2^-16 code could turn a rounding the other way, but do so for none of these pixels.
TEST(FloydSteinberg, FollowsTheRuleAsWritten) {
    for (const auto& [width, height] : {std::pair{1, 50}, {50, 1}, {2, 30}, {61, 47}}) {
        const Image<RGB> picture = random_picture(width, height, 55);
        const Image<CodeRGB> codes = quantize(FloydSteinberg{}, picture.view(), {}, 1);
        const Image<CodeRGB> plain = diffuse_plainly(picture);
        for (std::size_t i = 0; i < codes.pixels().size(); ++i) {
            ASSERT_EQ(codes.pixels()[i].g, plain.pixels()[i].g) << width << "x" << height << ", pixel " << i;
        }
    }
}

// By hand, in codes: 100.4 gives 100 and hands on 0.4, 7/13 of it to the right in the first column: 100.615 gives 101.
TEST(FloydSteinberg, FirstPixelsByHand) {
    const Image<std::uint16_t> codes = quantize(FloydSteinberg{}, constant_grey(3, 2, 100.4f / 255.0f).view(), {}, 1);
    // Row 0: 100.4 -> 100 (+.4); 100.6154 -> 101 (-.3846); 100.4 - 7/16 .3846 = 100.2317 -> 100 (+.2317).
    EXPECT_EQ(codes(0, 0), 100);
    EXPECT_EQ(codes(1, 0), 101);
    EXPECT_EQ(codes(2, 0), 100);
    // Row 1: 100.4 + 5/13 .4 - 3/16 .3846 = 100.4817 -> 100 (+.4817); the next
    // 100.4 + .4817 + 1/13 .4 - 5/16 .3846 + 3/8 .2317 = 100.8792 -> 101 (-.1208); the last
    // 100.4 - .1208 - 1/16 .3846 + 5/8 .2317 = 100.4000 -> 100. Sum 602 of 602.4: the last 0.4 is lost.
    EXPECT_EQ(codes(0, 1), 100);
    EXPECT_EQ(codes(1, 1), 101);
    EXPECT_EQ(codes(2, 1), 100);
}

TEST(FloydSteinberg, ChannelsAreIndependent) {
    const Image<RGB> picture = random_picture(57, 41, 53);
    Image<RGB> swapped = picture;
    for (RGB& p : swapped.pixels()) p = {p.b, 0.0f, p.r};
    const Image<CodeRGB> codes = quantize(FloydSteinberg{}, picture.view(), {}, 1);
    const Image<CodeRGB> swapped_codes = quantize(FloydSteinberg{}, swapped.view(), {}, 1);
    for (std::size_t i = 0; i < codes.pixels().size(); ++i) {
        ASSERT_EQ(swapped_codes.pixels()[i], (CodeRGB{codes.pixels()[i].b, 0, codes.pixels()[i].r}));
    }
}

// A bright part must not be left with errors of the dark one: means of 16 x 16 blocks within a code.
TEST(FloydSteinberg, KeepsTheMeanOfBlocks) {
    const Image<RGB> picture = random_picture(128, 128, 54);
    const Image<CodeRGB> codes = quantize(FloydSteinberg{}, picture.view(), {}, 1);
    for (int by = 0; by < 128; by += 16) {
        for (int bx = 0; bx < 128; bx += 16) {
            double difference = 0.0;
            for (int y = by; y < by + 16; ++y) {
                for (int x = bx; x < bx + 16; ++x) difference += codes(x, y).g - 255.0 * picture(x, y).g;
            }
            EXPECT_LT(std::abs(difference) / 256.0, 0.1) << bx << ", " << by;
        }
    }
}

// Errors that a saturated last row cannot take are carried to its end, and do not overflow.
TEST(FloydSteinberg, SurvivesSaturation) {
    Image<RGB> picture(70000, 2);
    for (int x = 0; x < picture.width(); ++x) {
        picture(x, 0) = {0.9999f, 0.9995f, 0.001f};
        picture(x, 1) = {1.0f, 1.0f, 0.0f};
    }
    const Image<CodeRGB> codes = quantize(FloydSteinberg{}, picture.view(), {}, 1);
    for (int x = 0; x < picture.width(); ++x) {
        ASSERT_GE(codes(x, 1).r, 254);
        ASSERT_GE(codes(x, 1).g, 254);
        ASSERT_LE(codes(x, 1).b, 1);
    }
}

}  // namespace
}  // namespace emulsion
