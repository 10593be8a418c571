#include "display/transfer_encoder.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/named_value.h"

namespace emulsion {
namespace {

/// The fast path for any number of values.
std::vector<float> encode_fast(const TransferFunction& transfer, const std::vector<float>& linear) {
    std::vector<RGB> pixels((linear.size() + 2) / 3);
    for (std::size_t i = 0; i < linear.size(); ++i) {
        RGB& p = pixels[i / 3];
        (i % 3 == 0 ? p.r : (i % 3 == 1 ? p.g : p.b)) = linear[i];
    }
    const TransferEncoder encoder(transfer);
    encoder(pixels);
    std::vector<float> encoded;
    for (const RGB& p : pixels) encoded.insert(encoded.end(), {p.r, p.g, p.b});
    encoded.resize(linear.size());
    return encoded;
}

double encode_exactly(const TransferFunction& transfer, float linear) {
    return std::max(encode(transfer, static_cast<double>(linear)), 0.0);
}

/// Floats of [0, 1] in order, with the ends: every 19997th down from the least, every 211th above 2^-10, those on
/// either side of every multiple of 2^16 in the bit pattern, where the segments of tables meet, and about the knees.
std::vector<float> floats_of_unit_interval() {
    const auto one = std::bit_cast<std::uint32_t>(1.0f);
    const auto small = std::bit_cast<std::uint32_t>(0x1p-10f);
    std::vector<std::uint32_t> bits;
    for (std::uint32_t b = 0; b < small; b += 19997) bits.push_back(b);
    for (std::uint32_t b = small; b < one; b += 211) bits.push_back(b);
    for (std::uint32_t b = 1u << 16u; b <= one; b += 1u << 16u) bits.insert(bits.end(), {b - 1, b, b + 1});
    for (const float knee : {0.0031308f, 0.018f, 0.0181f, 1.0f / 512.0f, 1.0f / 12.0f, 0.001f}) {
        const auto b = std::bit_cast<std::uint32_t>(knee);
        bits.insert(bits.end(), {b - 2, b - 1, b, b + 1, b + 2});
    }
    std::sort(bits.begin(), bits.end());
    bits.back() = one;
    std::vector<float> values;
    values.reserve(bits.size());
    for (const std::uint32_t b : bits) values.push_back(std::bit_cast<float>(b));
    return values;
}

/// The defaults, and others where a function has parameters.
std::vector<TransferFunction> all_transfers() {
    std::vector<TransferFunction> all;
    for_each_alternative<TransferFunction>([&](const auto& chosen) { all.emplace_back(chosen); });
    for (const double exponent : {0.1, 0.5, 1.0, 1.8, 5.0}) all.emplace_back(GammaTransfer{exponent});
    all.emplace_back(Bt1886Transfer{0.1, 100.0});
    all.emplace_back(Bt1886Transfer{1.0, 10.0});
    return all;
}

TEST(TransferEncoder, EndsAreExact) {
    for (const TransferFunction& transfer : all_transfers()) {
        const auto black = static_cast<float>(encode_exactly(transfer, 0.0f));
        EXPECT_EQ(encode_fast(transfer, {0.0f, -0.0f, 1.0f}), (std::vector<float>{black, black, 1.0f}))
            << to_text(transfer);
    }
    EXPECT_EQ(encode_exactly(SrgbTransfer{}, 0.0f), 0.0);
}

TEST(TransferEncoder, IsWithinItsTolerance) {
    const std::vector<float> linear = floats_of_unit_interval();
    for (const TransferFunction& transfer : all_transfers()) {
        const std::vector<float> encoded = encode_fast(transfer, linear);
        double worst = 0.0;
        for (std::size_t i = 0; i < linear.size(); ++i) {
            worst = std::max(worst, std::abs(encoded[i] - encode_exactly(transfer, linear[i])));
        }
        EXPECT_LT(worst, std::holds_alternative<SrgbTransfer>(transfer) ? 6e-8 : 6.4e-8) << to_text(transfer);
        RecordProperty(to_text(transfer), std::to_string(worst * 1e9) + "e-9");
    }
}

// But for the standards' own falls at a knee, 2.9e-8 of sRGB and 2.8e-6 of BT.2020.
TEST(TransferEncoder, NeverFallsButAtARoundedKnee) {
    const std::vector<float> linear = floats_of_unit_interval();
    for (const TransferFunction& transfer : all_transfers()) {
        const std::vector<float> encoded = encode_fast(transfer, linear);
        for (std::size_t i = 1; i < linear.size(); ++i) {
            const bool srgb_knee = std::holds_alternative<SrgbTransfer>(transfer) &&
                                   static_cast<double>(linear[i - 1]) <= 0.0031308 &&
                                   static_cast<double>(linear[i]) > 0.0031308;
            const bool bt2020_knee = std::holds_alternative<Bt2020Transfer>(transfer) &&
                                     static_cast<double>(linear[i - 1]) < 0.0181 &&
                                     static_cast<double>(linear[i]) >= 0.0181;
            if (srgb_knee || bt2020_knee) continue;
            ASSERT_LE(encoded[i - 1], encoded[i]) << to_text(transfer) << " at " << linear[i];
        }
    }
}

TEST(TransferEncoder, CodesSurviveDecodingAndEncoding) {
    for_each_alternative<TransferFunction>([](const auto& chosen) {
        const TransferFunction transfer = chosen;
        for (const int codes : {255, 65535}) {
            std::vector<float> linear;
            for (int code = 0; code <= codes; ++code) {
                linear.push_back(static_cast<float>(decode(transfer, static_cast<double>(code) / codes)));
            }
            const std::vector<float> encoded = encode_fast(transfer, linear);
            for (int code = 0; code <= codes; ++code) {
                // BT.709 has a gap between two 8-bit codes and over sixteen of 16 bits, which no light has.
                const double wanted = static_cast<double>(code) / codes;
                if (std::holds_alternative<Bt709Transfer>(transfer) && wanted > 0.081 && wanted < 0.08125) continue;
                const float got = encoded[static_cast<std::size_t>(code)];
                ASSERT_EQ(std::lround(got * static_cast<double>(codes)), code) << to_text(transfer);
            }
        }
    });
}

TEST(TransferEncoder, LightBelowTheBlackOfTheDisplayIsBlack) {
    constexpr Bt1886Transfer kDim{0.1, 100.0};
    EXPECT_EQ(encode_fast(kDim, {0.0f, 0.0005f, 0.00099999f}), std::vector<float>(3, 0.0f));
    EXPECT_GT(encode_fast(kDim, {0.00101f}).front(), 0.0f);
}

TEST(TransferEncoder, RefusesParametersOutOfRange) {
    EXPECT_THAT([] { TransferEncoder(GammaTransfer{0.0}); },
                testing::ThrowsMessage<std::invalid_argument>("transfer gamma: exponent = 0: must be in [0.1, 5]"));
}

}  // namespace
}  // namespace emulsion
