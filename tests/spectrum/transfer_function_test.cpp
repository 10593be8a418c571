#include "spectrum/transfer_function.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace emulsion {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Reference values below were computed from the standards' formulas with 30 digits, unless a source is named.

/// Where a function has two pieces, and by how much its code rises there from one to the other.
struct Knee {
    double linear, step;
};
template <class T>
std::optional<Knee> knee_of(const T& /*transfer*/) {
    return std::nullopt;
}
std::optional<Knee> knee_of(const SrgbTransfer& /*transfer*/) { return Knee{0.0031308, -2.85173098e-8}; }
std::optional<Knee> knee_of(const Bt709Transfer& /*transfer*/) { return Knee{0.018, 2.479440351405e-4}; }
std::optional<Knee> knee_of(const Bt2020Transfer& /*transfer*/) { return Knee{0.0181, -2.7965014658e-6}; }
std::optional<Knee> knee_of(const ProPhotoTransfer& /*transfer*/) { return Knee{1.0 / 512.0, 0.0}; }
std::optional<Knee> knee_of(const HlgTransfer& /*transfer*/) { return Knee{1.0 / 12.0, 0.0}; }

/// What 0 and 1 are encoded as, exactly.
template <class T>
std::pair<double, double> ends_of(const T& /*transfer*/) {
    return {0.0, 1.0};
}
std::pair<double, double> ends_of(const PqTransfer& /*transfer*/) { return {7.309559025783966e-7, 1.0}; }
std::pair<double, double> ends_of(const HlgTransfer& /*transfer*/) { return {0.0, 1.0 - 4.93386942e-9}; }

/// The parameters that the properties are tested for: the defaults, and others where there are any.
std::vector<TransferFunction> all_transfers() {
    std::vector<TransferFunction> all;
    for_each_alternative<TransferFunction>([&](const auto& chosen) { all.emplace_back(chosen); });
    all.emplace_back(GammaTransfer{1.0});
    all.emplace_back(GammaTransfer{0.5});
    all.emplace_back(Bt1886Transfer{0.1, 100.0});
    return all;
}

/// Calls test(chosen) for each of them, with its own type.
template <class Test>
void for_all_transfers(const Test& test) {
    for (const TransferFunction& transfer : all_transfers()) {
        SCOPED_TRACE(to_text(transfer));
        std::visit(test, transfer);
    }
}

/// Linear values from -2 to 2: even ones, small ones, and those about the knee.
template <class T>
std::vector<double> linear_values(const T& transfer) {
    std::vector<double> values;
    for (int i = 0; i <= 4000; ++i) values.push_back(i / 2000.0);
    for (double x = 1.0; x > 1e-12; x *= 0.9) values.push_back(x);
    if (const auto knee = knee_of(transfer)) {
        for (int i = -1000; i <= 1000; ++i) values.push_back(knee->linear * (1.0 + 1e-6 * i));
        for (const double to : {0.0, 1.0}) values.push_back(std::nextafter(knee->linear, to));
    }
    for (std::size_t i = values.size(); i-- > 0;) values.push_back(-values[i]);
    std::sort(values.begin(), values.end());
    return values;
}

TEST(TransferFunction, EndsAreAsStandardised) {
    for_each_alternative<TransferFunction>([](const auto& transfer) {
        SCOPED_TRACE(transfer.kName);
        const auto [zero, one] = ends_of(transfer);
        EXPECT_DOUBLE_EQ(encode(transfer, 0.0), zero);
        EXPECT_DOUBLE_EQ(encode(transfer, 1.0), one);
        EXPECT_EQ(decode(transfer, 0.0), 0.0);
        EXPECT_EQ(decode(transfer, zero), 0.0);
        EXPECT_DOUBLE_EQ(decode(transfer, one), 1.0);
        if (zero == 0.0) {
            EXPECT_EQ(encode(transfer, 0.0), 0.0);
        }
        if (one == 1.0) {
            EXPECT_EQ(encode(transfer, 1.0), 1.0);
            EXPECT_EQ(decode(transfer, 1.0), 1.0);
        }
    });
}

TEST(TransferFunction, DecodeUndoesEncode) {
    for_all_transfers([](const auto& transfer) {
        // A fall of the code at the knee makes two values of one code: they differ by the fall over the slope there.
        const auto knee = knee_of(transfer);
        const double fall = knee ? std::max(-knee->step, 0.0) : 0.0;
        for (const double linear : linear_values(transfer)) {
            const bool near_knee = knee && std::abs(std::abs(linear) / knee->linear - 1.0) < 1e-4;
            // Rounding: PQ's 78th and 6th powers magnify it.
            const double tolerance = 1e-12 * std::max(std::abs(linear), 1e-3) + (near_knee ? fall / 4.0 : 0.0);
            ASSERT_NEAR(decode(transfer, encode(transfer, linear)), linear, tolerance) << linear;
        }
    });
}

TEST(TransferFunction, EncodeUndoesDecode) {
    for_all_transfers([](const auto& transfer) {
        const auto knee = knee_of(transfer);
        for (int i = -1500; i <= 1500; ++i) {
            const double encoded = i / 1000.0;
            const bool in_gap = knee && knee->step > 0.0 && std::abs(encoded) >= 0.081 && std::abs(encoded) < 0.0813;
            const bool below_black = std::abs(encoded) < encode(transfer, 0.0);
            if (in_gap || below_black) continue;
            ASSERT_NEAR(encode(transfer, decode(transfer, encoded)), encoded, 1e-13) << encoded;
        }
    });
}

TEST(TransferFunction, IsOdd) {
    for_each_alternative<TransferFunction>([](const auto& transfer) {
        SCOPED_TRACE(transfer.kName);
        for (const double x : {1e-9, 0.001, 0.0031308, 0.018, 1.0 / 12.0, 0.3, 1.0, 1.9, 100.0}) {
            EXPECT_EQ(encode(transfer, -x), -encode(transfer, x)) << x;
            EXPECT_EQ(decode(transfer, -x), -decode(transfer, x)) << x;
        }
    });
}

TEST(TransferFunction, NeverFallsButAtARoundedKnee) {
    for_all_transfers([](const auto& transfer) {
        const auto knee = knee_of(transfer);
        const std::vector<double> linear = linear_values(transfer);
        for (std::size_t i = 1; i < linear.size(); ++i) {
            const double rise = encode(transfer, linear[i]) - encode(transfer, linear[i - 1]);
            const bool across = knee && std::max(std::abs(linear[i]), std::abs(linear[i - 1])) >= knee->linear &&
                                std::min(std::abs(linear[i]), std::abs(linear[i - 1])) <= knee->linear;
            ASSERT_GE(rise, across ? std::min(knee->step, 0.0) - 1e-16 : 0.0) << linear[i];
        }
        double before = -kInfinity;
        for (int i = -150000; i <= 150000; ++i) {
            const double decoded = decode(transfer, i / 100000.0);
            ASSERT_LE(before, decoded + 3e-8) << i;  // sRGB's decode falls by 2.2e-9 at its knee
            before = decoded;
        }
    });
}

TEST(TransferFunction, PiecesMeetAtTheKneeToTheDocumentedStep) {
    int knees = 0;
    for_each_alternative<TransferFunction>([&](const auto& transfer) {
        const auto knee = knee_of(transfer);
        if (!knee) return;
        SCOPED_TRACE(transfer.kName);
        const double below = encode(transfer, std::nextafter(knee->linear, 0.0));
        const double above = encode(transfer, std::nextafter(knee->linear, 1.0));
        EXPECT_NEAR(above - below, knee->step, 5e-16);  // besides the rise over two steps of a double
        ++knees;
    });
    EXPECT_EQ(knees, 5);
}

TEST(TransferFunction, NaNStaysNaNAndInfinityGoesToTheLimit) {
    for_all_transfers([](const auto& transfer) {
        EXPECT_TRUE(std::isnan(encode(transfer, kNaN)));
        EXPECT_TRUE(std::isnan(decode(transfer, kNaN)));
        EXPECT_EQ(decode(transfer, kInfinity), kInfinity);
        EXPECT_EQ(decode(transfer, -kInfinity), -kInfinity);
        const double limit = encode(transfer, kInfinity);
        EXPECT_EQ(encode(transfer, -kInfinity), -limit);
        EXPECT_GT(limit, 1.0);
        EXPECT_EQ(decode(transfer, limit), kInfinity);
    });
}

TEST(SrgbTransfer, HasTheStandardsValues) {
    constexpr SrgbTransfer kSrgb{};
    EXPECT_NEAR(encode(kSrgb, 0.001), 0.01292, 1e-15);
    EXPECT_NEAR(encode(kSrgb, 0.18), 0.461356129500, 1e-12);
    EXPECT_NEAR(encode(kSrgb, 0.5), 0.735356983052, 1e-12);
    EXPECT_NEAR(decode(kSrgb, 0.5), 0.214041140482, 1e-12);
    EXPECT_NEAR(decode(kSrgb, 10.0 / 255.0), 10.0 / 255.0 / 12.92, 1e-16);
    EXPECT_NEAR(decode(kSrgb, 128.0 / 255.0), 0.215860500114, 1e-12);
    EXPECT_DOUBLE_EQ(encode(kSrgb, 0.0031308), 12.92 * 0.0031308);
    EXPECT_DOUBLE_EQ(decode(kSrgb, 0.04045), 0.04045 / 12.92);
    const double decode_step = decode(kSrgb, std::nextafter(0.04045, 1.0)) - decode(kSrgb, 0.04045);
    EXPECT_LT(std::abs(decode_step), 3e-8);
}

TEST(GammaTransfer, IsAPower) {
    EXPECT_DOUBLE_EQ(decode(GammaTransfer{}, 0.5), std::exp2(-2.2));
    EXPECT_DOUBLE_EQ(encode(GammaTransfer{2.0}, 0.09), 0.3);
    EXPECT_EQ(encode(GammaTransfer{1.0}, 0.3), 0.3);
    EXPECT_THROW((void)parse_named<TransferFunction>("gamma:exponent=0", "transfer"), std::invalid_argument);
    EXPECT_EQ(parse_named<TransferFunction>("gamma:exponent=2.6", "transfer"), TransferFunction{GammaTransfer{2.6}});
}

TEST(AdobeRgbTransfer, IsThePowerOf563By256) {
    EXPECT_NEAR(encode(AdobeRgbTransfer{}, 0.18), 0.458529465679894602, 1e-15);
    EXPECT_NEAR(decode(AdobeRgbTransfer{}, 0.5), 0.217755528144394555, 1e-15);
}

TEST(Bt709Transfer, HasTheStandardsValues) {
    EXPECT_DOUBLE_EQ(encode(Bt709Transfer{}, 0.01), 0.045);
    EXPECT_NEAR(encode(Bt709Transfer{}, 0.018), 0.0812479440351404777, 1e-15);  // the upper piece has the knee
    EXPECT_NEAR(encode(Bt709Transfer{}, 0.18), 0.409007728864150443, 1e-15);
    EXPECT_NEAR(decode(Bt709Transfer{}, 0.5), 0.259589400506285740, 1e-15);
}

TEST(Bt709Transfer, CodesInTheGapDecodeToTheKnee) {
    EXPECT_LT(decode(Bt709Transfer{}, 0.0809999), 0.018);
    for (const double code : {0.0811, 0.0812, 0.08124}) EXPECT_EQ(decode(Bt709Transfer{}, code), 0.018) << code;
    EXPECT_GT(decode(Bt709Transfer{}, 0.08125), 0.018);
    EXPECT_EQ(decode(Bt709Transfer{}, -0.0812), -0.018);
}

TEST(Bt2020Transfer, HasTheStandardsValues) {
    EXPECT_DOUBLE_EQ(encode(Bt2020Transfer{}, 0.018), 0.081);
    EXPECT_NEAR(encode(Bt2020Transfer{}, 0.18), 0.408846402493503715, 1e-15);
    EXPECT_NEAR(decode(Bt2020Transfer{}, 4.5 * 0.0181) - 0.0181, 6.2231982e-7, 1e-14);
}

TEST(Bt1886Transfer, IsAPowerOf2_4WithoutBlack) {
    EXPECT_NEAR(decode(Bt1886Transfer{}, 0.5), 0.189464570813799760, 1e-15);
    EXPECT_EQ(decode(Bt1886Transfer{0.0, 400.0}, 0.5), decode(Bt1886Transfer{}, 0.5));
    EXPECT_NEAR(decode(Bt1886Transfer{}, 1e-20), 1e-48, 1e-62);
}

// The standard's own a and b for 0.1 and 100 cd/m^2: b = 0.0595848339685468651.
TEST(Bt1886Transfer, WithBlackIsTheStandardsFormula) {
    constexpr Bt1886Transfer kDim{0.1, 100.0};
    EXPECT_NEAR(decode(kDim, 0.5), 0.216049111673893652, 1e-15);
    EXPECT_NEAR(decode(kDim, 0.0), 0.001, 1e-17);
    EXPECT_EQ(decode(kDim, 1.0), 1.0);
    EXPECT_EQ(encode(kDim, 1.0), 1.0);
    // Light below black has negative codes, no light -b; there decode turns about.
    EXPECT_NEAR(encode(kDim, 0.0), -0.0595848339685468651, 1e-15);
    EXPECT_NEAR(decode(kDim, -0.0595848339685468651), 0.0, 1e-30);
    EXPECT_NEAR(decode(kDim, -2.0 * 0.0595848339685468651), -0.001, 1e-16);
}

// 203 cd/m^2 at 58 % and 1000 cd/m^2 at 75 % are also in ITU-R BT.2408.
TEST(PqTransfer, HasTheStandardsValues) {
    const auto code_of = [](double luminance_cdm2) { return encode(PqTransfer{}, luminance_cdm2 / 10000.0); };
    EXPECT_NEAR(code_of(0.0), 7.30955902578396630e-7, 1e-20);
    EXPECT_NEAR(code_of(0.0001), 0.00166718821785979448, 1e-15);
    EXPECT_NEAR(code_of(1.0), 0.149945732100179775, 1e-14);
    EXPECT_NEAR(code_of(100.0), 0.508078421517394855, 1e-14);
    EXPECT_NEAR(code_of(203.0), 0.580688881041607838, 1e-14);
    EXPECT_NEAR(code_of(1000.0), 0.751827096247041773, 1e-14);
    EXPECT_NEAR(code_of(4000.0), 0.902572393310940493, 1e-14);
    EXPECT_EQ(code_of(10000.0), 1.0);
    EXPECT_NEAR(decode(PqTransfer{}, 0.508078421517394855), 0.01, 1e-14);
}

TEST(PqTransfer, CodesBelowThatOfBlackAreBlackAndThoseAboveTheLimitInfinite) {
    EXPECT_EQ(decode(PqTransfer{}, 7.3e-7), 0.0);
    EXPECT_GT(decode(PqTransfer{}, 7.4e-7), 0.0);
    EXPECT_NEAR(encode(PqTransfer{}, kInfinity), 1.99206008185649049, 1e-13);
    EXPECT_EQ(decode(PqTransfer{}, 2.0), kInfinity);
    EXPECT_LT(decode(PqTransfer{}, 1.99), kInfinity);
}

// BT.2408: reference white, 75 % HLG, is 26.5 % of the scene's brightest light.
TEST(HlgTransfer, HasTheStandardsValues) {
    EXPECT_DOUBLE_EQ(encode(HlgTransfer{}, 1.0 / 12.0), 0.5);
    EXPECT_DOUBLE_EQ(encode(HlgTransfer{}, 0.03), 0.3);
    EXPECT_NEAR(encode(HlgTransfer{}, 0.5), 0.871643470874177183, 1e-15);
    EXPECT_DOUBLE_EQ(decode(HlgTransfer{}, 0.5), 1.0 / 12.0);
    EXPECT_NEAR(decode(HlgTransfer{}, 0.75), 0.264962560421007179, 1e-15);
}

TEST(ProPhotoTransfer, HasTheStandardsValues) {
    EXPECT_DOUBLE_EQ(encode(ProPhotoTransfer{}, 0.001), 0.016);
    EXPECT_DOUBLE_EQ(encode(ProPhotoTransfer{}, 1.0 / 512.0), 1.0 / 32.0);
    EXPECT_DOUBLE_EQ(decode(ProPhotoTransfer{}, 1.0 / 32.0), 1.0 / 512.0);
    EXPECT_NEAR(encode(ProPhotoTransfer{}, 0.18), 0.385711424751137632, 1e-15);
}

}  // namespace
}  // namespace emulsion
