// The kinds of sums beside one another: what they hold, where they stop, what they take.
#include "film/film_sums.h"

#include <cmath>
#include <string_view>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "core/named_value.h"
#include "core/random.h"
#include "film/film.h"
#include "film/filter_sampler.h"

namespace emulsion {
namespace {

/// A typed suite over all alternatives of FilmSums.
template <class Variant>
struct TypesOf;
template <class... Ts>
struct TypesOf<std::variant<Ts...>> {
    using Types = ::testing::Types<Ts...>;
};
template <class Sums>
class EveryFilm : public ::testing::Test {};
TYPED_TEST_SUITE(EveryFilm, TypesOf<FilmSums>::Types);

TYPED_TEST(EveryFilm, ReconstructsAConstant) {
    BasicFilm<TypeParam> film({4, 4, {}});
    const FilterSampler sampler(MitchellFilter{});
    auto tile = film.make_tile(film.bounds());
    Pcg32 random(2);
    for (int i = 0; i < 4 * 4 * 64; ++i) {
        tile.add(i % 4, i / 4 % 4, XYZ{0.3f, 40.0f, 5e6f},
                 sampler.sample(random.next_float(), random.next_float()).weight);
    }
    film.merge(tile);
    const Image<XYZ> image = film.xyz_image();
    for (const XYZ& pixel : image.pixels()) {
        // Plain floats lose half a unit in the last place of the sum with each of 64 samples: 64 2^-25 at worst.
        EXPECT_NEAR(pixel.x, 0.3f, 0.3f * 4e-6f);
        EXPECT_NEAR(pixel.y, 40.0f, 40.0f * 4e-6f);
        EXPECT_NEAR(pixel.z, 5e6f, 5e6f * 4e-6f);
    }
    EXPECT_EQ(film.sample_count(), 4u * 4u * 64u);
    EXPECT_EQ(film.saturated_pixels(), 0);
}

TYPED_TEST(EveryFilm, KeepsBadSamplesOut) {
    BasicFilm<TypeParam> film({2, 1, {}});
    auto tile = film.make_tile(film.bounds());
    tile.add(0, 0, XYZ{1.0f, std::nanf(""), 1.0f}, 1.0f);
    tile.add(0, 0, XYZ{1.0f, HUGE_VALF, 1.0f}, 1.0f);
    tile.add(0, 0, XYZ{1.0f, -1.0f, 1.0f}, 1.0f);
    tile.add(0, 0, XYZ{1.0f, 2.0f, 3.0f}, 1.0f);
    film.merge(tile);
    EXPECT_EQ(film.xyz_image()(0, 0), (XYZ{1.0f, 2.0f, 3.0f}));
    EXPECT_EQ(film.dropped().count(), 3u);
    EXPECT_EQ(film.sample_count(), 1u);
}

/// The sum of 2^24 samples of 1, and 1000 more.
template <class Sums>
double sum_of_many_ones() {
    typename Sums::TilePixel pixel;
    for (int i = 0; i < (1 << 24) + 1000; ++i) pixel.add(1.0, 1.0, 1.0, 1.0);
    return pixel.sums().xyz.y;
}

// 2^24 + 1 is the first whole number that is no float.
TEST(FilmSums, FloatStopsGrowingAfterSixteenMillionSamples) {
    EXPECT_EQ(sum_of_many_ones<FloatSums>(), 16777216.0);
    EXPECT_EQ(sum_of_many_ones<KahanFloatSums>(), 16778216.0);
    EXPECT_EQ(sum_of_many_ones<DoubleSums>(), 16778216.0);
    EXPECT_EQ(sum_of_many_ones<ExactSums>(), 16778216.0);
}

// The same where tiles meet the film: a film of 2^24 has a thousand tiles of one sample merged into it.
template <class Sums>
double film_of_many_ones() {
    BasicFilm<Sums> film({1, 1, {}});
    auto tile = film.make_tile(film.bounds());
    tile.add(0, 0, XYZ{1.0f, 1.0f, 1.0f}, 0x1p24f);
    film.merge(tile);
    tile.clear();
    tile.add(0, 0, XYZ{2.0f, 2.0f, 2.0f}, 0.5f);
    for (int i = 0; i < 1000; ++i) film.merge(tile);
    return static_cast<double>(film.xyz_image()(0, 0).y);
}

// Values: (2^24 + 1000) / (2^24 + 500), and 2^24 / 2^24 where neither sum grows any more.
TEST(FilmSums, FloatFilmsStopGrowingToo) {
    const double expected = static_cast<float>((0x1p24 + 1000.0) / (0x1p24 + 500.0));
    EXPECT_EQ(film_of_many_ones<FloatSums>(), 1.0);
    EXPECT_EQ(film_of_many_ones<KahanFloatSums>(), expected);
    EXPECT_EQ(film_of_many_ones<DoubleSums>(), expected);
    EXPECT_EQ(film_of_many_ones<ExactSums>(), expected);
}

// At most 48 bytes a pixel for the exact sums; the others as much as their numbers and a count.
TEST(FilmSums, TakeNoMoreMemoryThanTheyNeed) {
    EXPECT_EQ(sizeof(ExactSums::FilmPixel), 48u);
    EXPECT_EQ(sizeof(DoubleSums::FilmPixel), 40u);
    EXPECT_EQ(sizeof(FloatSums::FilmPixel), 20u);
    EXPECT_EQ(sizeof(KahanFloatSums::FilmPixel), 36u);
}

TEST(FilmSums, AreListedByName) {
    EXPECT_EQ(names_of<FilmSums>(), (std::vector<std::string_view>{"exact", "double", "float", "kahan-float"}));
    EXPECT_EQ(parse_named<FilmSums>("Kahan-Float", "sums"), FilmSums(KahanFloatSums{}));
}

}  // namespace
}  // namespace emulsion
