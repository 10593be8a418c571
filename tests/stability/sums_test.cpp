// Sums of samples: weights that cancel, samples that are no numbers, orders.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "film/film.h"
#include "film/filter_sampler.h"

namespace emulsion {
namespace {

constexpr XYZ grey(float luminance) { return {luminance, luminance, luminance}; }

constexpr int kSide_px = 300;

struct Range {
    float least = 0.0f, largest = 0.0f;
    [[nodiscard]] float size() const noexcept { return std::max(std::abs(least), std::abs(largest)); }
    void add(float value) noexcept {
        least = std::min(least, value);
        largest = std::max(largest, value);
    }
};

/// A picture of values in [0, 1), so many samples a pixel, uniform in the support of Mitchell's filter: sum(f v) /
/// sum(f).
Range weighted_by_the_filter(int samples) {
    const Filter filter = MitchellFilter{};
    const auto radius = static_cast<float>(radius_px(filter, FilterAxis::x));
    Pcg32 random(1);
    const auto weight = [&](FilterAxis axis) {
        return static_cast<float>(
            eval(filter, axis, static_cast<double>(radius * (2.0f * random.next_float() - 1.0f))));
    };
    Range range;
    for (int pixel = 0; pixel < kSide_px * kSide_px; ++pixel) {
        float sum = 0.0f, weights = 0.0f;
        for (int s = 0; s < samples; ++s) {
            const float x = weight(FilterAxis::x), y = weight(FilterAxis::y);
            sum += x * y * random.next_float();
            weights += x * y;
        }
        range.add(sum / weights);
    }
    return range;
}

/// The same picture through the film: places drawn by the filter, weights near 1 and -1.
Range drawn_by_the_filter(const Filter& filter, int samples, Film& film) {
    const FilterSampler sampler(filter);
    FilmTile tile = film.make_tile(film.bounds());
    Pcg32 random(1);
    for (int y = 0; y < kSide_px; ++y) {
        for (int x = 0; x < kSide_px; ++x) {
            for (int s = 0; s < samples; ++s) {
                const float u = random.next_float(), v = random.next_float();
                tile.add(x, y, grey(random.next_float()), sampler.sample(u, v).weight);
            }
        }
    }
    film.merge(tile);
    Range range;
    const Image<XYZ> picture = film.xyz_image();
    for (const XYZ& pixel : picture.pixels()) range.add(pixel.y);
    return range;
}

// Weights of both signs may add up to next to nothing. In the film weights are f over a density close to |f|, of 1.15
// in the mean, and a pixel whose mean weight is below 1/64 has no value and is counted: so none can come to more
// than 74.
TEST(CancellingWeights, LeaveThousandsWhereNoSampleIsAboveOne) {
    EXPECT_GT(weighted_by_the_filter(2).size(), 1000.0f);
    EXPECT_GT(weighted_by_the_filter(16).size(), 50.0f);

    Film two({kSide_px, kSide_px, {}}), sixteen({kSide_px, kSide_px, {}});
    EXPECT_NEAR(drawn_by_the_filter(MitchellFilter{}, 2, two).size(), 30.0f, 0.1f);
    EXPECT_NEAR(static_cast<double>(two.pixels_without_value()) / (kSide_px * kSide_px), 0.0965, 0.0005);
    EXPECT_NEAR(drawn_by_the_filter(MitchellFilter{}, 16, sixteen).size(), 1.09f, 0.01f);
    EXPECT_EQ(sixteen.pixels_without_value(), 0);
}

TEST(NonFiniteSamples, OneIsAllThatIsLeftOfAPixel) {
    const std::vector<float> bad = {std::nanf(""), HUGE_VALF, -HUGE_VALF};
    Film film({3, 1, {}});
    FilmTile tile = film.make_tile(film.bounds());
    for (int x = 0; x < 3; ++x) {
        float plain = 0.0f;
        for (int i = 0; i < 1000; ++i) {
            const float value = i == 500 ? bad[static_cast<std::size_t>(x)] : 2.0f;
            plain += value / 1000.0f;
            tile.add(x, 0, grey(value), 1.0f);
        }
        EXPECT_FALSE(std::isfinite(plain)) << x;
    }
    film.merge(tile);
    const Image<XYZ> picture = film.xyz_image();
    for (const XYZ& pixel : picture.pixels()) EXPECT_EQ(pixel, grey(2.0f));
    // Kept out, counted by kind, and the first are told with their pixel.
    EXPECT_EQ(film.dropped().count(DroppedKind::nan), 1u);
    EXPECT_EQ(film.dropped().count(DroppedKind::infinite), 2u);
    ASSERT_EQ(film.dropped().first().size(), 3u);
    EXPECT_EQ(film.dropped().first()[1].x_px, 1);
}

/// Samples [begin, end) of 64 x 64 pixels, over four decades, each a function of its pixel and index.
template <class Sums>
void add_samples(BasicFilm<Sums>& film, int begin, int end) {
    auto tile = film.make_tile(film.bounds());
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            for (int i = begin; i < end; ++i) {
                Pcg32 random(static_cast<std::uint64_t>(64 * y + x), static_cast<std::uint64_t>(i));
                tile.add(x, y, grey(std::exp(9.0f * random.next_float())), 1.0f);
            }
        }
    }
    film.merge(tile);
}

/// Pixels that differ between a run of 48 samples, and the same in three parts: the last, which another machine has
/// done, comes first, and the run was stopped after its first 7 samples and went on from there.
template <class Sums>
int pixels_that_differ() {
    const FilmOptions options{64, 64, {}};
    BasicFilm<Sums> whole(options), parts(options), first(options), second(options);
    add_samples(whole, 0, 48);
    add_samples(parts, 32, 48);
    add_samples(first, 0, 7);
    add_samples(second, 7, 32);
    first.merge(second);
    parts.merge(first);
    const Image<XYZ> a = whole.xyz_image(), b = parts.xyz_image();
    int count = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) count += a.pixels()[i] == b.pixels()[i] ? 0 : 1;
    return count;
}

TEST(OrderOfSums, ResumedAndMergedFilmsDifferInFloatSums) {
    EXPECT_NEAR(pixels_that_differ<FloatSums>(), 2603, 30);
    EXPECT_NEAR(pixels_that_differ<KahanFloatSums>(), 986, 30);
    EXPECT_EQ(pixels_that_differ<ExactSums>(), 0);
}

}  // namespace
}  // namespace emulsion
