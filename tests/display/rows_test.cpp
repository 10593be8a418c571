// The inner loops over rows: a pixel comes out the same wherever in a row it lies, in a vector or behind the last one,
// and by the plain functions.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"
#include "display/code_rows.h"
#include "display/code_units.h"
#include "display/display_rgb_rows.h"
#include "display/encode_rows.h"
#include "display/gamut_rows.h"
#include "spectrum/transfer_function.h"

namespace emulsion {
namespace {

constexpr int kMostPixels = 67;

/// In and around [0, 1], and some that are no colours.
std::vector<float> values(std::size_t count, std::uint64_t seed) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity(), kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr std::array kSpecial = {0.0f, -0.0f, 1.0f, 1e-42f, -1e-42f, kNan, kInfinity, -kInfinity, 0x1p100f};
    Pcg32 random(seed);
    std::vector<float> all(count);
    for (float& v : all) {
        v = 1.4f * random.next_float() - 0.2f;
        if (random.next_float() < 0.05f) v = kSpecial.at(random.next() % kSpecial.size());
    }
    return all;
}

std::vector<RGB> pixels(std::size_t count, std::uint64_t seed) {
    const std::vector<float> all = values(3 * count, seed);
    std::vector<RGB> pixels(count);
    for (std::size_t i = 0; i < count; ++i) pixels[i] = {all[3 * i], all[3 * i + 1], all[3 * i + 2]};
    return pixels;
}

/// Bits, so that NaN is equal to itself; all NaN are one.
std::uint32_t bits(float v) { return v != v ? 0x7fc00000u : std::bit_cast<std::uint32_t>(v); }
std::array<std::uint32_t, 3> bits(const RGB& rgb) { return {bits(rgb.r), bits(rgb.g), bits(rgb.b)}; }

TEST(Rows, LinearRgbIsTheProduct) {
    constexpr std::array kMatrix = {3.24f, -1.54f, -0.5f, -0.97f, 1.88f, 0.04f, 0.06f, -0.2f, 1.06f};
    for (int count = 0; count <= kMostPixels; ++count) {
        std::vector<XYZ> xyz;
        for (const RGB& p : pixels(static_cast<std::size_t>(count), 1)) xyz.push_back({p.r, p.g, p.b});
        std::vector<RGB> rgb(xyz.size());
        linear_rgb(kMatrix, 0.01f, xyz, rgb);
        for (std::size_t i = 0; i < rgb.size(); ++i) {
            const auto& [x, y, z] = xyz[i];
            const auto component = [&, &x = x, &y = y, &z = z](std::size_t row) {
                return kMatrix.at(3 * row) * x + kMatrix.at(3 * row + 1) * y + kMatrix.at(3 * row + 2) * z - 0.01f;
            };
            ASSERT_EQ(bits(rgb[i]), bits(RGB{component(0), component(1), component(2)})) << count << " " << i;
        }
    }
}

TEST(Rows, ClippingAndCountsAreThoseOfEachPixel) {
    for (int count = 0; count <= kMostPixels; ++count) {
        const std::vector<RGB> before = pixels(static_cast<std::size_t>(count), 2);
        std::vector<RGB> row = before;
        const GamutCounts counts = clip_row(row);
        GamutCounts expected;
        for (std::size_t i = 0; i < before.size(); ++i) {
            float excess = 0.0f;
            bool is_nan = false;
            const std::array in = {before[i].r, before[i].g, before[i].b}, out = {row[i].r, row[i].g, row[i].b};
            for (std::size_t c = 0; c < 3; ++c) {
                const float v = in.at(c);
                is_nan = is_nan || v != v;
                if (v == v) excess = std::max({excess, -v, v - 1.0f});
                ASSERT_EQ(out.at(c), v > 0.0f ? std::min(v, 1.0f) : 0.0f) << count << " " << i;
            }
            expected += {!is_nan && excess > kGamutTolerance ? 1 : 0, is_nan ? 1 : 0, excess};
        }
        ASSERT_EQ(counts, expected) << count;

        std::vector<float> excess(before.size());
        ASSERT_EQ(measure_row(before, excess), expected) << count;
        for (std::size_t i = 0; i < before.size(); ++i) {
            std::vector<float> alone(1);
            (void)measure_row({&before[i], 1}, alone);
            ASSERT_EQ(excess[i], alone[0]) << count << " " << i;
        }
    }
}

TEST(Rows, CurvesAreThoseOfEachValue) {
    constexpr float kLast = 0.0031308f;
    const CurveTable table([](double x) { return encode(SrgbTransfer{}, x); }, kLast);
    const StraightToeCurve straight{kLast, 12.92f, 0.0f, table};
    const SquareRootToeCurve root{kLast, table};
    for (std::size_t count = 0; count <= kMostPixels; ++count) {
        const std::vector<float> before = values(count, 3);
        std::vector<float> by_straight = before, by_root = before;
        encode_row(straight, by_straight);
        encode_row(root, by_root);
        for (std::size_t i = 0; i < count; ++i) {
            ASSERT_EQ(bits(by_straight[i]), bits(straight(before[i]))) << before[i];
            ASSERT_EQ(bits(by_root[i]), bits(root(before[i]))) << before[i];
        }
    }
}

TEST(Rows, CodesAreThoseOfEachValue) {
    Pcg32 random(4);
    for (const CodeScale& scale : {CodeScale{0, 1}, CodeScale{0, 255}, CodeScale{64, 940}, CodeScale{0, 65535}}) {
        const CodeUnits units(scale);
        const int fraction_bits = units.fraction_bits(), unused_bits = 16 - fraction_bits;
        for (std::size_t count = 0; count <= kMostPixels; ++count) {
            const std::vector<float> encoded = values(count, 5);
            std::vector<Threshold> first(count), second(count);
            for (Threshold& t : first) t = static_cast<Threshold>(random.next() >> 16u);
            for (Threshold& t : second) t = static_cast<Threshold>(random.next() >> 16u);
            std::vector<std::uint16_t> nearest(count), thresholded(count), triangular(count);
            round_to_nearest(encoded, scale, nearest);
            round_by_thresholds(encoded, first, scale, thresholded);
            round_with_triangular_noise(encoded, first, second, scale, triangular);
            for (std::size_t i = 0; i < count; ++i) {
                const double exact = double{unit_clamp(encoded[i])} * scale.steps();
                ASSERT_EQ(nearest[i], scale.black + static_cast<int>(std::floor(exact + 0.5))) << encoded[i];
                const int value = units(encoded[i]), a = first[i] >> unused_bits, b = second[i] >> unused_bits;
                ASSERT_EQ(thresholded[i], scale.black + ((value + a) >> fraction_bits)) << encoded[i];
                const int half = units.per_code() / 2;
                const bool near_end = value < half || value > units.white() - half;
                const int noise = near_end ? a : a + b + 1 - half;
                ASSERT_EQ(triangular[i], scale.black + ((value + noise) >> fraction_bits)) << encoded[i];
            }
        }
    }
}

}  // namespace
}  // namespace emulsion
