#include "display/transfer_encoder.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/named_value.h"
#include "core/parallel.h"

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
    for (const double exponent : {0.1, 0.5, 1.0, 1.7, 1.8, 2.4, 2.6, 5.0}) all.emplace_back(GammaTransfer{exponent});
    all.emplace_back(Bt1886Transfer{0.1, 100.0});
    all.emplace_back(Bt1886Transfer{1.0, 10.0});
    all.emplace_back(TableTransfer{{{0.0, 0.0}, {0.1, 0.0}, {0.25, 0.02}, {0.5, 0.25}, {1.0, 1.0}}});
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

// Pixels that don't fill a vector go another way, to the same bits; those outside of [0, 1], too.
TEST(TransferEncoder, EveryPixelHasTheSameBitsAloneAndInARow) {
    std::vector<float> linear = floats_of_unit_interval();
    for (const float odd : {-1.0f, -0.0f, 1.5f, 1e30f, -1e30f, std::numeric_limits<float>::quiet_NaN(),
                            std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()}) {
        linear.push_back(odd);
    }
    for (const TransferFunction& transfer : all_transfers()) {
        const TransferEncoder encoder(transfer);
        const std::vector<float> together = encode_fast(transfer, linear);
        for (std::size_t i = 0; i < linear.size(); i += i + 1000 < linear.size() ? 97 : 1) {
            RGB alone{linear[i], linear[i], linear[i]};
            encoder({&alone, 1});
            ASSERT_EQ(std::bit_cast<std::uint32_t>(alone.g), std::bit_cast<std::uint32_t>(together[i]))
                << to_text(transfer) << " of " << linear[i];
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

/// One encoder, and what it has to come to.
struct ExhaustiveCase {
    std::string name;
    TransferEncoder fast;
    std::function<double(double)> exact;
    double knee = 0.0;  ///< the last value of the lower piece, where the standard's own pieces fall; 0: nowhere
};

std::ostream& operator<<(std::ostream& stream, const ExhaustiveCase& one) { return stream << one.name; }

std::vector<ExhaustiveCase> exhaustive_cases() {
    std::vector<ExhaustiveCase> cases;
    for (const TransferFunction& transfer : all_transfers()) {
        ExhaustiveCase one{to_text(transfer), TransferEncoder(transfer),
                           [transfer](double x) { return std::max(encode(transfer, x), 0.0); }};
        if (std::holds_alternative<SrgbTransfer>(transfer)) one.knee = SrgbTransfer::kLinearKnee;
        if (std::holds_alternative<Bt2020Transfer>(transfer)) one.knee = std::nextafter(0.0181, 0.0);
        cases.push_back(one);
    }
    for (const DisplayLight& light : {DisplayLight{1000.0, 0.0}, DisplayLight{1000.0, 0.05}}) {
        cases.push_back({"pq of a display with a black of " + number_text(light.black_cdm2),
                         TransferEncoder(PqTransfer{}, light),
                         [light](double x) { return encode(PqTransfer{}, pq_linear(light, x)); }});
    }
    return cases;
}

class TransferEncoderEveryFloat : public testing::TestWithParam<ExhaustiveCase> {};

// All 1065353217 floats of [0, 1]: within 0.01 of a 16-bit code of the exact value, and never below the float before.
TEST_P(TransferEncoderEveryFloat, IsWithinItsToleranceAndNeverFalls) {
    constexpr std::uint32_t kPerBlock = 3u << 14u;
    constexpr std::uint32_t kCount = std::bit_cast<std::uint32_t>(1.0f) + 1;
    const ExhaustiveCase& param = GetParam();
    constexpr int kBlocks = static_cast<int>((kCount + kPerBlock - 1) / kPerBlock);
    std::vector<double> worst(kBlocks);
    std::vector<int> falls(kBlocks);
    parallel_for(0, kBlocks, 0, [&](int block) {
        const std::uint32_t begin = static_cast<std::uint32_t>(block) * kPerBlock;
        const auto float_at = [&](std::uint32_t i) { return std::bit_cast<float>(std::min(begin + i, kCount - 1)); };
        // One pixel more, for the first float of the next block.
        std::vector<RGB> pixels(kPerBlock / 3 + 1);
        for (std::uint32_t i = 0; i < pixels.size(); ++i) {
            pixels[i] = {float_at(3 * i), float_at(3 * i + 1), float_at(3 * i + 2)};
        }
        param.fast(pixels);
        const auto encoded_at = [&](std::uint32_t i) {
            const RGB& p = pixels[i / 3];
            return i % 3 == 0 ? p.r : (i % 3 == 1 ? p.g : p.b);
        };
        const auto at = static_cast<std::size_t>(block);
        for (std::uint32_t i = 0; i < kPerBlock; ++i) {
            const double x = float_at(i), next = float_at(i + 1), encoded = encoded_at(i);
            worst[at] = std::max(worst[at], std::abs(encoded - param.exact(x)));
            const bool at_knee = param.knee > 0.0 && x <= param.knee && next > param.knee;
            falls[at] += encoded_at(i + 1) < encoded && !at_knee ? 1 : 0;
        }
    });
    const double largest = *std::max_element(worst.begin(), worst.end());
    RecordProperty("codes_of_16_bits", std::to_string(largest * 65535.0));
    EXPECT_LT(largest * 65535.0, 0.01);
    EXPECT_EQ(std::accumulate(falls.begin(), falls.end(), 0), 0);
}

INSTANTIATE_TEST_SUITE_P(Long, TransferEncoderEveryFloat, testing::ValuesIn(exhaustive_cases()),
                         [](const testing::TestParamInfo<ExhaustiveCase>& chosen) {
                             std::string name = std::to_string(chosen.index) + '_';
                             for (const char c : chosen.param.name) name += std::isalnum(c) != 0 ? c : '_';
                             return name;
                         });

TEST(TransferEncoder, RefusesParametersOutOfRange) {
    EXPECT_THAT([] { TransferEncoder(GammaTransfer{0.0}); },
                testing::ThrowsMessage<std::invalid_argument>("transfer gamma: exponent = 0: must be in [0.1, 5]"));
}

}  // namespace
}  // namespace emulsion
