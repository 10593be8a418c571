#include "display/transfer_function.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "core/named_value.h"

namespace emulsion {
namespace {

constexpr SrgbTransfer kSrgb{};

/// The fast path for any number of values.
std::vector<float> encode_fast(const TransferFunction& transfer, const std::vector<float>& linear) {
    std::vector<RGB> pixels((linear.size() + 2) / 3);
    for (std::size_t i = 0; i < linear.size(); ++i) {
        RGB& p = pixels[i / 3];
        (i % 3 == 0 ? p.r : (i % 3 == 1 ? p.g : p.b)) = linear[i];
    }
    encode(transfer, pixels);
    std::vector<float> encoded;
    for (const RGB& p : pixels) encoded.insert(encoded.end(), {p.r, p.g, p.b});
    encoded.resize(linear.size());
    return encoded;
}

/// Floats of [0, 1] in order, with the ends: every 997th down from the least, every 61st above 2^-10, and on either
/// side of every multiple of 2^16 in the bit pattern, where the segments of tables meet.
std::vector<float> floats_of_unit_interval() {
    const auto one = std::bit_cast<std::uint32_t>(1.0f);
    const auto small = std::bit_cast<std::uint32_t>(0x1p-10f);
    std::vector<std::uint32_t> bits;
    for (std::uint32_t b = 0; b < small; b += 997) bits.push_back(b);
    for (std::uint32_t b = small; b < one; b += 61) bits.push_back(b);
    for (std::uint32_t b = small; b <= one; b += 1u << 16u) bits.insert(bits.end(), {b - 1, b, b + 1});
    bits.back() = one;
    std::sort(bits.begin(), bits.end());
    std::vector<float> values;
    values.reserve(bits.size());
    for (const std::uint32_t b : bits) values.push_back(std::bit_cast<float>(b));
    return values;
}

TEST(TransferFunction, EndsAreExact) {
    for_each_alternative<TransferFunction>([](const auto& chosen) {
        const TransferFunction transfer = chosen;
        EXPECT_EQ(encode(transfer, 0.0), 0.0);
        EXPECT_EQ(encode(transfer, 1.0), 1.0);
        EXPECT_EQ(decode(transfer, 0.0), 0.0);
        EXPECT_EQ(decode(transfer, 1.0), 1.0);
        EXPECT_EQ(encode_fast(transfer, {0.0f, 1.0f}), (std::vector<float>{0.0f, 1.0f}));
    });
}

TEST(TransferFunction, DecodeUndoesEncode) {
    for_each_alternative<TransferFunction>([](const auto& chosen) {
        const TransferFunction transfer = chosen;
        for (int i = 0; i <= 100000; ++i) {
            const double linear = i / 100000.0;
            ASSERT_NEAR(decode(transfer, encode(transfer, linear)), linear, 3e-8) << linear;
        }
    });
}

TEST(TransferFunction, FastPathIsWithinItsTolerance) {
    for_each_alternative<TransferFunction>([](const auto& chosen) {
        const TransferFunction transfer = chosen;
        const std::vector<float> linear = floats_of_unit_interval();
        const std::vector<float> encoded = encode_fast(transfer, linear);
        double worst = 0.0;
        for (std::size_t i = 0; i < linear.size(); ++i) {
            worst = std::max(worst, std::abs(encoded[i] - encode(transfer, static_cast<double>(linear[i]))));
        }
        EXPECT_LT(worst, 6e-8);
    });
}

TEST(TransferFunction, CodesSurviveDecodingAndEncoding) {
    for_each_alternative<TransferFunction>([](const auto& chosen) {
        const TransferFunction transfer = chosen;
        for (const int codes : {255, 65535}) {
            std::vector<float> linear;
            for (int code = 0; code <= codes; ++code) {
                const double decoded = decode(transfer, static_cast<double>(code) / codes);
                ASSERT_EQ(std::lround(encode(transfer, decoded) * codes), code);
                linear.push_back(static_cast<float>(decoded));
            }
            const std::vector<float> encoded = encode_fast(transfer, linear);
            for (int code = 0; code <= codes; ++code) {
                ASSERT_EQ(std::lround(encoded[static_cast<std::size_t>(code)] * static_cast<double>(codes)), code);
            }
        }
    });
}

// By hand from the formulas of IEC 61966-2-1, to 12 digits.
TEST(SrgbTransfer, HasTheStandardsValues) {
    EXPECT_NEAR(encode(kSrgb, 0.001), 0.01292, 1e-15);
    EXPECT_NEAR(encode(kSrgb, 0.18), 0.461356129500, 1e-12);
    EXPECT_NEAR(encode(kSrgb, 0.5), 0.735356983052, 1e-12);
    EXPECT_NEAR(decode(kSrgb, 0.5), 0.214041140482, 1e-12);
    EXPECT_NEAR(decode(kSrgb, 10.0 / 255.0), 10.0 / 255.0 / 12.92, 1e-16);
    EXPECT_NEAR(decode(kSrgb, 128.0 / 255.0), 0.215860500114, 1e-12);
}

TEST(SrgbTransfer, KneeFallsByTheStandardsRounding) {
    const double below = encode(kSrgb, 0.0031308);
    const double above = encode(kSrgb, std::nextafter(0.0031308, 1.0));
    EXPECT_NEAR(below - above, 2.85173e-8, 1e-13);
    const double decode_step = decode(kSrgb, std::nextafter(0.04045, 1.0)) - decode(kSrgb, 0.04045);
    EXPECT_LT(std::abs(decode_step), 3e-8);
}

// But for the standard's own step at the knee, which is smaller than the distance of two 16-bit codes by far.
TEST(SrgbTransfer, RisesOnBothSidesOfTheKnee) {
    const std::vector<float> linear = floats_of_unit_interval();
    const std::vector<float> encoded = encode_fast(kSrgb, linear);
    for (std::size_t i = 1; i < linear.size(); ++i) {
        const bool across_knee = linear[i - 1] <= 0.0031308f && linear[i] > 0.0031308f;
        if (across_knee) continue;
        ASSERT_LE(encoded[i - 1], encoded[i]) << linear[i];
        ASSERT_LE(encode(kSrgb, static_cast<double>(linear[i - 1])), encode(kSrgb, static_cast<double>(linear[i])));
    }
}

}  // namespace
}  // namespace emulsion
