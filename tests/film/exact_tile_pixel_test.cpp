#include "film/exact_tile_pixel.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "film/exact_film_pixel.h"

namespace emulsion {
namespace {

/// The specification: every term is rounded on its own, by ExactSum, and then all are added up.
struct SlowPixel {
    ExactSum x, y, z;
    ExactWeightSum weight;
    void add(double x_value, double y_value, double z_value, double w) {
        x += ExactSum(w * x_value);
        y += ExactSum(w * y_value);
        z += ExactSum(w * z_value);
        weight += ExactWeightSum(w);
    }
    [[nodiscard]] WeightedSums sums() const { return {{x.value(), y.value(), z.value()}, weight.value()}; }
};

/// Of either sign, of sizes from far below the resolution to `largest`.
double wild(Pcg32& random, int largest_exponent) {
    const auto mantissa = static_cast<double>(random.next()) * 0x1p-32 + static_cast<double>(random.next()) * 0x1p-64;
    const int exponent = static_cast<int>(random.next() % static_cast<std::uint32_t>(60 + largest_exponent)) - 60;
    return std::ldexp(random.next() % 4u == 0 ? -mantissa : mantissa, exponent);
}

TEST(ExactTilePixel, SumsAreThoseOfRoundedTerms) {
    for (const int largest_exponent : {0, 10, 23, 26, 38}) {  // quick terms, large ones, and both
        Pcg32 random(static_cast<std::uint64_t>(largest_exponent));
        ExactTilePixel pixel;
        SlowPixel slow;
        for (int i = 0; i < 4000; ++i) {
            const double x = wild(random, largest_exponent), y = wild(random, largest_exponent),
                         z = wild(random, largest_exponent), weight = wild(random, 2);
            ASSERT_TRUE(pixel.add(x, y, z, weight));
            slow.add(x, y, z, weight);
            ASSERT_EQ(pixel.sums(), slow.sums()) << i;
            if (i % 1000 == 999) pixel.carry();
            ASSERT_EQ(pixel.sums(), slow.sums()) << "carried";
        }
        EXPECT_FALSE(slow.x.is_saturated());
    }
}

// Weights of all sizes, those that are added one by one among them, and counts beyond 2^13 = 8192 quick terms, from
// which on the bits of the constants have gone round.
TEST(ExactTilePixel, TakesWeightsOfAnySize) {
    Pcg32 random(7);
    ExactTilePixel pixel;
    SlowPixel slow;
    for (int i = 0; i < 30000; ++i) {
        const double x = wild(random, 3), weight = wild(random, i % 100 == 99 ? 20 : 3);
        ASSERT_TRUE(pixel.add(x, 1.0, -x, weight));
        slow.add(x, 1.0, -x, weight);
        ASSERT_EQ(pixel.sums(), slow.sums()) << i;
        if (i % 12000 == 11999) pixel.carry();
    }
    EXPECT_EQ(pixel.sums(), slow.sums());
}

// Either side of the largest term that is added quickly, of either sign, in each channel.
TEST(ExactTilePixel, TermsAroundTheQuickLimit) {
    for (const double limit : {0x1p27, 0x1p6}) {
        for (const double size : {0.5 * limit, std::nextafter(limit, 0.0), limit, std::nextafter(limit, 1e9)}) {
            for (const double value : {size, -size}) {
                ExactTilePixel pixel;
                SlowPixel slow;
                for (int i = 0; i < 3; ++i) {
                    const bool is_weight = limit == 0x1p6;
                    const double weight = is_weight ? value : 1.0, x = is_weight ? 0.1 : value;
                    ASSERT_TRUE(pixel.add(x, -x, x / 3.0, weight));
                    slow.add(x, -x, x / 3.0, weight);
                }
                EXPECT_EQ(pixel.sums(), slow.sums()) << value;
            }
        }
    }
}

// Ties of both parts: halves of the resolution, beside a multiple of it.
TEST(ExactTilePixel, TiesGoToEven) {
    for (const double value : {2.5 * 0x1p-44, 3.5 * 0x1p-44, -2.5 * 0x1p-44, 1.5 * 0x1p-9 + 2.5 * 0x1p-44,
                               0x1p-10 + 0x1p-45, -0x1p-10 - 0x1p-45, 3 * 0x1p-10 + 0x1.8p-44, 0.5 * 0x1p-44}) {
        ExactTilePixel pixel;
        pixel.add(value, -value, 0.0, 1.0);
        EXPECT_EQ(pixel.sums().xyz.x, ExactSum(value).value()) << value;
        EXPECT_EQ(pixel.sums().xyz.y, -ExactSum(value).value()) << value;
    }
}

TEST(ExactTilePixel, RefusesWhatIsNotFinite) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    ExactTilePixel pixel;
    pixel.add(1.0, 2.0, 3.0, 0.5);
    const WeightedSums before = pixel.sums();
    for (const double bad : {nan, infinity, -infinity}) {
        EXPECT_FALSE(pixel.add(bad, 1.0, 1.0, 1.0));
        EXPECT_FALSE(pixel.add(1.0, bad, 1.0, 1.0));
        EXPECT_FALSE(pixel.add(1.0, 1.0, bad, 1.0));
        EXPECT_FALSE(pixel.add(1.0, 1.0, 1.0, bad));
        EXPECT_FALSE(pixel.add(0.0, bad, -bad, 1e30));
    }
    EXPECT_EQ(pixel.sums(), before);
}

TEST(ExactTilePixel, SaturatesChannelByChannelAndStaysThere) {
    ExactTilePixel pixel;
    pixel.add(0x1p51, -1e40, 5.0, 1.0);
    for (int i = 0; i < 3; ++i) {
        pixel.add(-0x1p50, 0x1p50, 1.0, 1.0);
        pixel.add(-1e4, 1e4, 1.0, 1.0);
        pixel.carry();
    }
    EXPECT_EQ(pixel.sums(), (WeightedSums{{0x1p51, -0x1p51, 11.0}, 7.0}));
    ExactFilmPixel film;
    film.add(pixel, 7);
    EXPECT_TRUE(film.is_saturated());

    ExactTilePixel heavy;
    film = {};
    heavy.add(0.0, 0.0, 0.0, 0x1p31);
    film.add(heavy, 1);
    EXPECT_FALSE(film.is_saturated());
    heavy.add(0.0, 0.0, 0.0, 0x1p31);
    for (int i = 0; i < 3; ++i) {
        heavy.add(0.0, 0.0, 0.0, -0x1p31);
        heavy.add(0.0, 0.0, 0.0, -1.0);
        heavy.carry();
    }
    film.add(heavy, 7);
    EXPECT_TRUE(film.is_saturated());
}

// Two tiles whose sums are within the range, and beyond it together.
TEST(ExactTilePixel, FilmPixelSaturatesWhereTilesDoNot) {
    ExactTilePixel tile;
    tile.add(0x1.8p50, 1.0, 1.0, 1.0);
    ExactFilmPixel film;
    film.add(tile, 1);
    EXPECT_FALSE(film.is_saturated());
    film.add(tile, 1);
    EXPECT_TRUE(film.is_saturated());
    EXPECT_EQ(film.sums().xyz.x, 0x1p51);
    EXPECT_EQ(film.sums().xyz.y, 2.0);
}

TEST(ExactTilePixel, FilmCountsSamplesUpToItsLimit) {
    ExactFilmPixel film;
    film.add({}, 4000000000u);
    EXPECT_FALSE(film.is_saturated());
    film.add({}, 294967294u);
    EXPECT_EQ(film.samples(), 4294967294u);
    EXPECT_FALSE(film.is_saturated());
    film.add({}, 4000000000u);
    EXPECT_EQ(film.samples(), 4294967295u) << "not wrapped";
    EXPECT_TRUE(film.is_saturated());
}

TEST(ExactTilePixel, CountsItsTermsWhateverTheirSize) {
    Pcg32 random(11);
    ExactTilePixel pixel;
    for (std::uint64_t i = 1; i <= 9000; ++i) {
        const double weight = i % 5 == 0 ? 1e4 : 0.5;  // added one by one, and quick
        ASSERT_TRUE(pixel.add(wild(random, 30), 1.0, 1.0, i % 7 == 0 ? -weight : weight));
        if (i % 1000 == 0) pixel.carry();
        ASSERT_EQ(pixel.samples(), i);
    }
    EXPECT_FALSE(pixel.add(std::numeric_limits<double>::quiet_NaN(), 1.0, 1.0, 1.0));
    EXPECT_EQ(pixel.samples(), 9000u);
}

/// With values on both sides of what is added quickly to blocks (8), and of either sign.
std::vector<float> wild_weights(Pcg32& random, std::size_t count) {
    std::vector<float> made;
    for (std::size_t k = 0; k < count; ++k) {
        const float size = std::ldexp(1.0f, static_cast<int>(random.next() % 8u) - 4);  // up to 8
        made.push_back((random.next() % 4u == 0 ? -1.0f : 1.0f) *
                       (random.next() % 16u == 0 ? size : size * random.next_float()));
    }
    return made;
}

/// On both sides of 2^21, with the same meaning.
XYZd wild_xyz(Pcg32& random) {
    const int exponent = random.next() % 8u == 0 ? 26 : 20;
    return {wild(random, exponent), wild(random, exponent), random.next() % 16u == 0 ? -0x1p21 : wild(random, 10)};
}

void add_one_by_one(std::vector<ExactTilePixel>& pixels, std::size_t stride, const std::vector<float>& x_weights,
                    const std::vector<float>& y_weights, const XYZd& xyz) {
    for (std::size_t y = 0; y < y_weights.size(); ++y) {
        for (std::size_t x = 0; x < x_weights.size(); ++x) {
            pixels[y * stride + x].add(xyz.x, xyz.y, xyz.z, static_cast<double>(x_weights[x] * y_weights[y]));
        }
    }
}

void expect_same_bits(const std::vector<ExactTilePixel>& block, const std::vector<ExactTilePixel>& single) {
    for (std::size_t k = 0; k < block.size(); ++k) {
        ASSERT_TRUE(block[k].x_units() == single[k].x_units() && block[k].y_units() == single[k].y_units() &&
                    block[k].z_units() == single[k].z_units());
        ASSERT_TRUE(block[k].weight_units() == single[k].weight_units());
        ASSERT_EQ(block[k].samples(), single[k].samples());
    }
}

// Of any width, with and without a rest to four.
TEST(ExactTilePixel, BlocksAreTheSameBitsAsPixelsOneByOne) {
    Pcg32 random(13);
    for (int i = 0; i < 3000; ++i) {
        SCOPED_TRACE(i);
        const std::size_t width = 1 + random.next() % 9u, height = 1 + random.next() % 5u, stride = width + 2;
        const std::vector<float> x_weights = wild_weights(random, width), y_weights = wild_weights(random, height);
        const XYZd xyz = wild_xyz(random);
        std::vector<ExactTilePixel> block(stride * height), single(stride * height);
        ExactTilePixel::add_block(block.data(), static_cast<std::ptrdiff_t>(stride), x_weights, y_weights, xyz);
        add_one_by_one(single, stride, x_weights, y_weights, xyz);
        ASSERT_NO_FATAL_FAILURE(expect_same_bits(block, single));
    }
}

TEST(ExactTilePixel, FourByFourAreTheSameBitsAsPixelsOneByOne) {
    Pcg32 random(17);
    for (int i = 0; i < 3000; ++i) {
        SCOPED_TRACE(i);
        constexpr std::size_t kStride = 7;
        const std::vector<float> x = wild_weights(random, 4), y = wild_weights(random, 4);
        const XYZd wild_value = wild_xyz(random);
        const Float4 xyz = {static_cast<float>(wild_value.x), static_cast<float>(wild_value.y),
                            static_cast<float>(wild_value.z), random.next_float()};
        std::vector<ExactTilePixel> block(kStride * 4), single(kStride * 4);
        ExactTilePixel::add_four_by_four(block.data(), kStride, Float4{x[0], x[1], x[2], x[3]},
                                         Float4{y[0], y[1], y[2], y[3]}, xyz);
        add_one_by_one(single, kStride, x, y,
                       {static_cast<double>(xyz[0]), static_cast<double>(xyz[1]), static_cast<double>(xyz[2])});
        ASSERT_NO_FATAL_FAILURE(expect_same_bits(block, single));
    }
}

}  // namespace
}  // namespace emulsion
