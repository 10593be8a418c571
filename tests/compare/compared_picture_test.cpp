// What a picture knows of its own noise.

#include "compare/compared_picture.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compare/squared_difference.h"
#include "compare_fixture.h"

namespace emulsion {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(ComparedPicture, PixelsOfOneSampleTellNoNoise) {
    const ComparedPicture film = noisy_film(1, 0.0f, FilmVariance::xyz, 1);
    EXPECT_EQ(film.noise, KnownNoise::xyz);
    EXPECT_TRUE(std::isnan(film.standard_error(7, 7).y));
    EXPECT_EQ(squared_difference(film, noisy_film(2, 0.0f, FilmVariance::xyz, 1), {.white = d65()}, 0).parts,
              std::nullopt);
}

TEST(ComparedPicture, TakesNoiseInTheFilesUnitAndTheObserverFromTheHeader) {
    FilmImage image;
    image.xyz = Image<XYZ>(2, 1);
    image.data_window = {0, 0, 2, 1};
    image.width_px = 2;
    image.height_px = 1;
    image.floats.push_back({"standard-error.Y", Image<float>(2, 1)});
    image.floats[0].values(1, 0) = 3.0f;
    image.white_luminance_cdm2 = 8.0;
    image.metadata.film = "variance=luminance observer=cie-1964-10deg camera=none";
    const ComparedPicture picture = compared_picture(image);
    EXPECT_EQ(picture.noise, KnownNoise::luminance);
    EXPECT_EQ(picture.standard_error(1, 0), (XYZ{0.0f, 24.0f, 0.0f}));
    EXPECT_EQ(picture.observer, "cie-1964-10deg");
    EXPECT_EQ(picture.seeds, std::vector<std::uint64_t>{});
    image.metadata.renderer_version = "test 1";
    image.metadata.seed = 5;
    EXPECT_EQ(compared_picture(image).seeds, std::vector<std::uint64_t>{5});
}

TEST(ComparedPicture, OfTwoIsTheirMeanWithHalfTheirDifferenceAsNoise) {
    ComparedPicture first = constant({10.0, 20.0, 30.0}), second = constant({14.0, 14.0, 31.0});
    first.seeds = {1};
    second.seeds = {2};
    const ComparedPicture mean = mean_of(first, second);
    EXPECT_EQ(mean.noise, KnownNoise::xyz);
    EXPECT_EQ(mean.xyz(3, 2), (XYZ{12.0f, 17.0f, 30.5f}));
    EXPECT_EQ(mean.standard_error(3, 2), (XYZ{2.0f, 3.0f, 0.5f}));
    EXPECT_EQ(mean.seeds, (std::vector<std::uint64_t>{1, 2}));
    EXPECT_EQ(common_seed(mean, second), 2U);
    EXPECT_EQ(common_seed(first, second), std::nullopt);
}

// One is twice as noisy as the other, of samples that nobody has counted: the square of the error is right in the mean.
// Of exponential samples, its relative standard deviation over 30000 pixels is below 0.03.
TEST(ComparedPicture, OfTwoKnowsItsNoiseWhateverItComesFrom) {
    const ComparedPicture mean =
        mean_of(noisy_film(1, 0.0f, FilmVariance::none, 2), noisy_film(2, 0.0f, FilmVariance::none, 8));
    double squares = 0.0;
    for (const XYZ& error : mean.standard_error.pixels()) squares += double{error.y} * error.y;
    const double expected = 0.25 * (900.0 / 2.0 + 900.0 / 8.0);
    EXPECT_NEAR(squares / 30000.0, expected, 4.0 * 0.03 * expected);
}

TEST(ComparedPicture, TwoThatAreNotTheSamePictureTwiceAreRefused) {
    ComparedPicture picture = constant(d65());
    EXPECT_THAT([&] { (void)mean_of(picture, constant(d65(), 7, 6)); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("expected the same of the same frame")));
    picture.seeds = {7};
    EXPECT_THAT([&] { (void)mean_of(picture, picture); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("both pictures have seed 7")));
    ComparedPicture other = constant(d65());
    other.observer = "cie_1964_10deg";
    EXPECT_THROW((void)mean_of(picture, other), std::invalid_argument);
}

}  // namespace
}  // namespace emulsion
