// What is done against fireflies, and what it costs.

#include "film/firefly_control.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "film/film.h"

namespace emulsion {
namespace {

XYZ grey(float luminance) { return {luminance, luminance, luminance}; }

TEST(FireflyControl, IsOffByDefault) {
    EXPECT_EQ(FilmOptions{}.firefly_control, FireflyControl(NoFireflyControl{}));
    EXPECT_EQ(parse_named<FireflyControl>("clamp:luminance=20", "firefly"), FireflyControl(LuminanceClamp{20.0f}));
    EXPECT_EQ(to_text(FireflyControl(MedianOfMeans{})), "median-of-means:groups=5");
}

TEST(FireflyControl, ClampScalesDownAndKeepsCount) {
    // ISO 200: 10 cd/m^2 are 20 on the film.
    Film film({.width_px = 1, .height_px = 1, .sensor = {.iso = 200.0}, .firefly_control = LuminanceClamp{10.0f}});
    FilmTile tile = film.make_tile(film.bounds());
    tile.add(0, 0, XYZ{1.0f, 20.0f, 3.0f}, 1.0f);   // just not
    tile.add(0, 0, XYZ{4.0f, 40.0f, 80.0f}, 1.0f);  // to a half
    tile.add(0, 0, grey(HUGE_VALF), 1.0f);
    tile.add(0, 0, XYZ{HUGE_VALF, 1e3f, 1.0f}, 1.0f);
    tile.add(0, 0, grey(1e6f), std::nanf(""));
    film.merge(tile);
    const FilmCounts counts = film.counts();
    EXPECT_EQ(counts.samples, 2u);
    EXPECT_EQ(counts.clamped.count, 1u);
    EXPECT_EQ(counts.clamped.removed_luminance.value(), 20.0);
    EXPECT_EQ(counts.dropped.count(DroppedKind::infinite), 2u);
    EXPECT_EQ(counts.dropped.count(DroppedKind::nan), 1u);
    EXPECT_EQ(film.xyz_image()(0, 0), (XYZ{1.5f, 20.0f, 21.5f}));
}

// A limit that no float holds would keep every sample out, or none.
TEST(FireflyControl, RefusesAClampBeyondSinglePrecision) {
    FilmOptions options{.width_px = 1, .height_px = 1, .firefly_control = LuminanceClamp{1e-20f}};
    EXPECT_NO_THROW(Film{options});
    options.sensor.exposure_time_s = 1e-25;
    EXPECT_THROW(Film{options}, std::invalid_argument);
    options.sensor.exposure_time_s = 1e25;
    options.firefly_control = LuminanceClamp{1e20f};
    EXPECT_THROW(Film{options}, std::invalid_argument);
}

// What was removed is what the plain film has more: the bias that the file's header states.
TEST(FireflyControl, RemovedLuminanceIsTheDifferenceToThePlainFilm) {
    for (const FilterUse use : {FilterUse::importance_sampled, FilterUse::splatted}) {
        FilmOptions options{.width_px = 2, .height_px = 1, .filter = GaussianFilter{}, .filter_use = use};
        Film plain(options);
        options.firefly_control = LuminanceClamp{2.0f};
        Film clamped(options);
        for (Film* film : {&plain, &clamped}) {
            // Splatted, most samples lie in the margin, and count for what of them reaches in.
            const PixelBounds places = film->sample_bounds();
            FilmTile tile = film->make_tile(places);
            Pcg32 random(6);
            for (int i = 0; i < 1000; ++i) {
                const XYZ value = grey(std::exp(6.0f * random.next_float() - 4.0f));
                if (use == FilterUse::splatted) {
                    const float u = random.next_float(), v = random.next_float();
                    tile.add_at(static_cast<float>(places.x0) + u * static_cast<float>(places.width()),
                                static_cast<float>(places.y0) + v * static_cast<float>(places.height()), value);
                } else {
                    tile.add(0, 0, value, i % 10 == 0 ? -0.5f : 1.0f);
                }
            }
            film->merge(tile);
        }
        double plain_sum = 0.0, clamped_sum = 0.0;
        plain.for_each_pixel([&](std::size_t, const PixelSums& sums) { plain_sum += sums.weighted.xyz.y; });
        clamped.for_each_pixel([&](std::size_t, const PixelSums& sums) { clamped_sum += sums.weighted.xyz.y; });
        EXPECT_GT(clamped.counts().clamped.count, 100u);
        EXPECT_NEAR(clamped.counts().clamped.removed_luminance.value(), plain_sum - clamped_sum, 1e-5 * plain_sum);
    }
}

/// 500 samples about 1, a hundred to each of five groups, and one of them a firefly.
void add_samples_with_firefly(Film& film, float firefly) {
    FilmTile tile = film.make_tile(film.bounds());
    Pcg32 random(3);
    for (std::uint64_t i = 0; i < 500; ++i) {
        tile.set_sample_index(i);
        tile.add(0, 0, grey(i == 123 ? firefly : 0.5f + random.next_float()), 1.0f);
    }
    film.merge(tile);
}

TEST(FireflyControl, MedianOfMeansShrugsOffAFirefly) {
    FilmOptions options{.width_px = 1, .height_px = 1, .firefly_control = MedianOfMeans{5}};
    Film calm(options), burning(options);
    add_samples_with_firefly(calm, 1.0f);
    add_samples_with_firefly(burning, 1e6f);
    EXPECT_NEAR(calm.xyz_image()(0, 0).y, 1.0f, 0.05f);
    EXPECT_NEAR(burning.xyz_image()(0, 0).y, 1.0f, 0.06f);
    burning.for_each_pixel([](std::size_t, const PixelSums& sums) {
        EXPECT_NEAR(mean_of(sums)->y, 2001.0, 0.1) << "the plain mean is kept beside it";
    });
}

// Three samples in three groups: the middle one by luminance, with its own X and Z; four groups: the mean of two.
TEST(FireflyControl, MedianIsOneOfTheMeans) {
    const auto pixel_of = [](int groups, std::initializer_list<XYZ> samples) {
        Film film({.width_px = 1, .height_px = 1, .firefly_control = MedianOfMeans{groups}});
        FilmTile tile = film.make_tile(film.bounds());
        std::uint64_t index = 0;
        for (const XYZ& sample : samples) {
            tile.set_sample_index(index++);
            tile.add(0, 0, sample, 1.0f);
        }
        film.merge(tile);
        return film.xyz_image()(0, 0);
    };
    const XYZ a{9.0f, 1.0f, 7.0f}, b{8.0f, 2.0f, 1.0f}, c{0.0f, 3.0f, 2.0f}, d{1.0f, 50.0f, 1.0f};
    EXPECT_EQ(pixel_of(3, {c, a, b}), b);
    EXPECT_EQ(pixel_of(4, {d, c, a, b}), (XYZ{4.0f, 2.5f, 1.5f}));
    EXPECT_EQ(pixel_of(5, {d, c, a}), c) << "groups without samples do not count";
    EXPECT_EQ(pixel_of(3, {a, b, c, a, b, c}), b);
}

// A group whose weights cancel to less than 1/64 of its samples has no value, however many these are.
TEST(FireflyControl, GroupsOfVeryManySamplesMayCancel) {
    const FilmSetup setup(FilmOptions{.width_px = 1, .height_px = 1, .firefly_control = MedianOfMeans{3}});
    std::vector<ExactSum> channels(static_cast<std::size_t>(setup.channels.sums));
    const auto fill = [&](std::size_t group, double luminance, double weight) {
        const std::size_t at = static_cast<std::size_t>(setup.channels.means.begin) + 4 * group;
        for (std::size_t i = 0; i < 3; ++i) channels[at + i] = ExactSum(weight * luminance);
        channels[at + 3] = ExactSum(weight);
    };
    fill(0, 3.0, 3.6e8);
    fill(1, 5.0, 1e6);
    fill(2, 5.0, 1e6);
    const PixelSums sums{{{3e8, 3e8, 3e8}, 3.62e8}, 1'100'000'000, channels};
    const auto value = camera_value_of(sums, setup);
    ASSERT_TRUE(value);
    EXPECT_DOUBLE_EQ(value->y, 3.0);
}

// Sample i is in group i mod 5 whatever the order, the tile and the run.
TEST(FireflyControl, GroupsDoNotDependOnTheOrder) {
    const FilmOptions options{.width_px = 1, .height_px = 1, .firefly_control = MedianOfMeans{5}};
    Film forwards(options), backwards(options);
    for (std::uint64_t i = 0; i < 100; ++i) {
        const auto add = [](Film& film, std::uint64_t index) {
            FilmTile tile = film.make_tile(film.bounds());
            tile.set_sample_index(index);
            Pcg32 random(index);
            tile.add(0, 0, grey(random.next_float()), 1.0f);
            film.merge(tile);
        };
        add(forwards, i);
        add(backwards, 99 - i);
    }
    EXPECT_TRUE(forwards.contents() == backwards.contents());
}

}  // namespace
}  // namespace emulsion
