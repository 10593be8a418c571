#include "display/dither.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>
#include <variant>

#include <gtest/gtest.h>

#include "dither_fixture.h"

namespace emulsion {
namespace {

// --- Every dither

/// Calls visitor(dither, scale) for every dither and scale.
template <class Visitor>
void for_each_case(const Visitor& visitor) {
    for (const Dither& dither : every_dither()) {
        for (const CodeScale& scale : every_scale()) {
            SCOPED_TRACE(label(dither, scale));
            visitor(dither, scale);
        }
    }
}

TEST(Dither, BlackAndWhiteAreExact) {
    for_each_case([](const Dither& dither, const CodeScale& scale) {
        for (const auto& [value, code] : {std::pair{0.0f, scale.black}, {1.0f, scale.white}}) {
            const Image<std::uint16_t> codes = quantize(dither, constant_grey(67, 35, value).view(), scale, 1);
            for (const int c : codes.pixels()) ASSERT_EQ(c, code);
        }
    });
}

// The float nearest to every code of up to 16 bits.
TEST(Dither, CodesAreKeptExactly) {
    for_each_case([](const Dither& dither, const CodeScale& scale) {
        if (std::holds_alternative<TriangularNoise>(dither)) return;  // the same noise at every value
        const int columns = std::min(256, scale.steps() + 1);
        Image<float> ramp(columns, (scale.steps() + columns) / columns);
        const auto code_at = [&](int i) { return std::min(i, scale.steps()); };
        int i = 0;
        for (float& p : ramp.pixels()) p = static_cast<float>(static_cast<double>(code_at(i++)) / scale.steps());
        const Image<std::uint16_t> codes = quantize(dither, ramp.view(), scale, 1);
        i = 0;
        for (const int code : codes.pixels()) ASSERT_EQ(code, scale.black + code_at(i++));
    });
}

TEST(Dither, CodesAreNeighboursOfAConstant) {
    for_each_case([](const Dither& dither, const CodeScale& scale) {
        const double farthest = std::holds_alternative<TriangularNoise>(dither) ? 1.5 : 1.0;
        for (int grey = 0; grey <= 1020; grey += 51) {
            const float value = static_cast<float>(grey) / 1020.0f;
            const double exact = scale.black + static_cast<double>(value) * scale.steps();
            const Image<std::uint16_t> codes = quantize(dither, constant_grey(64, 64, value).view(), scale, 1);
            for (const int c : codes.pixels()) ASSERT_LE(std::abs(c - exact), farthest) << value;
        }
    });
}

TEST(Dither, AnyBitsGiveDefinedCodes) {
    for_each_case([](const Dither& dither, const CodeScale& scale) {
        constexpr float kInf = std::numeric_limits<float>::infinity();
        constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
        Image<RGB> bad(3, 1);
        bad(0, 0) = {kNan, -1.0f, -0.0f};
        bad(1, 0) = {kInf, 1e30f, 1.0f};
        bad(2, 0) = {-kInf, -std::numeric_limits<float>::denorm_min(), 2.0f};
        const Image<CodeRGB> codes = quantize(dither, bad.view(), scale, 1);
        const auto black = static_cast<std::uint16_t>(scale.black), white = static_cast<std::uint16_t>(scale.white);
        EXPECT_EQ(codes(0, 0), (CodeRGB{black, black, black}));
        EXPECT_EQ(codes(1, 0), (CodeRGB{white, white, white}));
        EXPECT_EQ(codes(2, 0), (CodeRGB{black, black, white}));
    });
}

TEST(Dither, NoCodeOutsideTheScale) {
    const Image<RGB> picture = random_picture(97, 61, 56);
    for_each_case([&](const Dither& dither, const CodeScale& scale) {
        const Image<CodeRGB> codes = quantize(dither, picture.view(), scale, 1);
        for (const CodeRGB& c : codes.pixels()) {
            ASSERT_GE(std::min({c.r, c.g, c.b}), scale.black);
            ASSERT_LE(std::max({c.r, c.g, c.b}), scale.white);
        }
    });
}

TEST(Dither, SameCodesForEveryNumberOfThreads) {
    for (const auto& [width, height] : {std::pair{301, 203}, {1, 40}, {40, 1}, {700, 5}, {3, 300}}) {
        const Image<RGB> picture = random_picture(width, height, 50);
        for_each_case([&](const Dither& dither, const CodeScale& scale) {
            const Image<CodeRGB> one = quantize(dither, picture.view(), scale, 1);
            for (const int threads : {2, 5, 0}) ASSERT_EQ(quantize(dither, picture.view(), scale, threads), one);
        });
    }
}

TEST(Dither, SameCodesOfValuesThatAreMadeWhenAskedFor) {
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 40}, {40, 1}, {2500, 7}, {3, 300}}) {
        const Image<RGB> picture = random_picture(width, height, 51);
        for_each_case([&, &width = width, &height = height](const Dither& dither, const CodeScale& scale) {
            const Image<CodeRGB> codes = quantize(dither, picture.view(), scale, 1);
            for (const int threads : {1, 3}) {
                Image<int> times(width, height);
                const auto make = [&](int y, int x0, std::span<RGB> pixels) {
                    for (std::size_t i = 0; i < pixels.size(); ++i) {
                        const int x = x0 + static_cast<int>(i);
                        pixels[i] = picture(x, y);
                        ++times(x, y);
                    }
                };
                Image<CodeRGB> made(width, height);
                quantize_into(dither, make, scale, made.view(), threads);
                ASSERT_EQ(made, codes) << label(dither, scale);
                for (const int t : times.pixels()) ASSERT_EQ(t, 1) << label(dither, scale);
            }
        });
    }
}

/// How far the mean of a constant may be off, in codes, for dithers that are known not to keep it to 1e-4.
double codes_off(const NoDither& /*dither*/) { return 0.5; }
/// 4.5 standard deviations of the mean of 256^2 errors of variance 1/4 at most: one of 182 cases is beyond with a
/// probability of 0.12 %.
double codes_off(const WhiteNoise& /*dither*/) { return 4.5 * 0.5 / 256.0; }
double codes_off(const TriangularNoise& /*dither*/) { return 4.5 * 0.5 / 256.0; }
/// Half a level of whole tiles, and a unit of 2^-16 code that values and thresholds are rounded to.
double codes_off(const Bayer& dither) { return 0.5 / (dither.size * dither.size) + 0x1p-16; }
double codes_off(const BlueNoise& dither) { return 0.5 / (dither.size * dither.size) + 0x1p-16; }
/// Turned cells have no fewer pixels.
double codes_off(const Halftone& dither) { return 0.5 / (dither.size * dither.size) + 0x1p-16; }
/// A quarter of each error is lost on purpose; errors are up to half a code.
double codes_off(const Atkinson& /*dither*/) { return 0.125; }
/// Other error diffusion keeps it.
template <class ErrorDiffusion>
double codes_off(const ErrorDiffusion& /*dither*/) {
    return 0.0;
}

/// The largest difference between the mean and the value, of 26 greys, the ends among them; 256 x 256 pixels. In
/// encoded values.
double mean_error(const Dither& dither, const CodeScale& scale) {
    double largest = 0.0;
    for (int i = 0; i <= 25; ++i) {
        const float value = static_cast<float>(i) / 25.0f;
        const Image<std::uint16_t> codes = quantize(dither, constant_grey(256, 256, value).view(), scale, 1);
        largest = std::max(largest, std::abs(mean_of(codes, scale) - static_cast<double>(value)));
    }
    return largest;
}

TEST(Dither, KeepsTheMeanOfEveryGrey) {
    for_each_case([](const Dither& dither, const CodeScale& scale) {
        const double off = std::visit([](const auto& chosen) { return codes_off(chosen); }, dither);
        EXPECT_LE(mean_error(dither, scale), std::max(1e-4, off / scale.steps() + 1e-7));
    });
}

// What fails 1e-4, and what doesn't: one bit asks most.
TEST(Dither, MeanOfOneBit) {
    const CodeScale one_bit{0, 1};
    const auto error = [&](const Dither& dither) { return mean_error(dither, one_bit); };
    EXPECT_NEAR(error(NoDither{}), 0.48, 0.001);
    EXPECT_NEAR(error(WhiteNoise{}), 3e-3, 2e-3);
    EXPECT_NEAR(error(Bayer{8}), 7.5e-3, 0.1e-3);
    EXPECT_NEAR(error(Halftone{2}), 0.12, 0.001);
    EXPECT_NEAR(error(Halftone{4}), 0.03, 0.001);
    EXPECT_NEAR(error(Atkinson{}), 0.117, 0.001);
    EXPECT_NEAR(error(BlueNoise{64}), 1.27e-4, 0.05e-4);
    EXPECT_LT(error(BlueNoise{128}), 0.4e-4);
    EXPECT_LT(error(Bayer{128}), 0.4e-4);
    EXPECT_LT(error(FloydSteinberg{}), 0.16e-4);
}

TEST(Dither, GreyIsWhatEachChannelOfAPictureIs) {
    const Image<RGB> picture = random_picture(57, 41, 53);
    Image<float> red(57, 41);
    for (std::size_t i = 0; i < red.pixels().size(); ++i) red.pixels()[i] = picture.pixels()[i].r;
    for_each_case([&](const Dither& dither, const CodeScale& scale) {
        if (dither == Dither(Halftone{.screens = kPlateScreens})) return;  // black has an angle of its own
        const Image<CodeRGB> codes = quantize(dither, picture.view(), scale, 1);
        const Image<std::uint16_t> red_codes = quantize(dither, red.view(), scale, 1);
        for (std::size_t i = 0; i < red.pixels().size(); ++i) ASSERT_EQ(red_codes.pixels()[i], codes.pixels()[i].r);
    });
}

TEST(Dither, RejectsWhatItCannotDo) {
    for (const Dither& dither : every_dither()) {
        const Image<RGB> picture(2, 2);
        Image<CodeRGB> smaller(1, 2);
        Image<std::uint16_t> taller(2, 3);
        EXPECT_THROW((void)quantize(dither, Image<RGB>().view(), {}, 1), std::invalid_argument);
        EXPECT_THROW((void)quantize(dither, picture.view(), {}, -1), std::invalid_argument);
        EXPECT_THROW(quantize_into(dither, picture.view(), {}, smaller.view(), 1), std::invalid_argument);
        EXPECT_THROW(quantize_into(dither, Image<float>(2, 2).view(), {}, taller.view(), 1), std::invalid_argument);
        const MakeEncoded black = [](int, int, std::span<RGB> pixels) { std::ranges::fill(pixels, RGB{}); };
        EXPECT_THROW(quantize_into(dither, black, {}, smaller.view(), -1), std::invalid_argument);
        const MakeEncoded fails = [](int, int, std::span<RGB>) { throw std::runtime_error("no light"); };
        EXPECT_THROW(quantize_into(dither, fails, {}, smaller.view(), 2), std::runtime_error);
    }
}

// --- Rounding

TEST(NoDither, RoundsToNearestWithHalvesUp) {
    const auto code = [](float value) {
        return static_cast<int>(quantize(NoDither{}, constant_grey(1, 1, value).view(), {}, 1)(0, 0));
    };
    EXPECT_EQ(code(0.5f), 128);  // 127.5
    EXPECT_EQ(code(std::nextafter(0.5f, 0.0f)), 127);
    for (int i = 0; i < 255; ++i) {
        const auto edge = static_cast<float>((i + 0.5) / 255.0);
        EXPECT_EQ(code(edge), static_cast<int>(std::floor(255.0 * edge + 0.5))) << i;
        EXPECT_EQ(code(edge - 1e-6f), i);
        EXPECT_EQ(code(edge + 1e-6f), i + 1);
    }
}

}  // namespace
}  // namespace emulsion
