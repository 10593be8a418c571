// The film's sums do not depend on the order of anything: merges, samples, tiles, shares of the samples, threads.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "film/film.h"

namespace emulsion {
namespace {

FilmOptions options(int width_px, int height_px) { return {width_px, height_px, {}}; }

/// Overlapping tiles with samples of very different sizes, whose sums in doubles depend on the order.
std::vector<FilmTile> wild_tiles(const Film& film) {
    std::vector<FilmTile> tiles;
    Pcg32 random(3);
    for (int i = 0; i < 40; ++i) {
        const int x0 = i % 7, y0 = i % 5;
        FilmTile tile = film.make_tile({x0, y0, x0 + 9, y0 + 8});
        for (int s = 0; s < 500; ++s) {
            const int x = x0 + s % 9, y = y0 + s / 9 % 8;
            const float size = std::ldexp(1.0f, static_cast<int>(random.next() % 80u) - 40);
            tile.add(x, y, XYZ{size * random.next_float(), size, size * random.next_float()},
                     random.next_float() < 0.1f ? -1.1f : 1.1f);
        }
        tiles.push_back(tile);
    }
    return tiles;
}

Image<XYZ> merged(const std::vector<FilmTile>& tiles) {
    Film film(options(16, 12));
    for (const FilmTile& tile : tiles) film.merge(tile);
    return film.xyz_image();
}

TEST(FilmOrder, IsBitIdenticalForAThousandOrdersOfMerges) {
    const Film film(options(16, 12));
    std::vector<FilmTile> tiles = wild_tiles(film);
    const Image<XYZ> expected = merged(tiles);
    double plain = 0.0, plain_reversed = 0.0;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        plain += tiles[i].pixels()[40].sums().xyz.y;
        plain_reversed += tiles[tiles.size() - 1 - i].pixels()[40].sums().xyz.y;
    }
    EXPECT_NE(plain, plain_reversed) << "the tiles are too tame for this test to say anything";

    std::mt19937 shuffler(1);
    for (int i = 0; i < 1000; ++i) {
        std::shuffle(tiles.begin(), tiles.end(), shuffler);
        ASSERT_EQ(merged(tiles), expected) << "shuffle " << i;
    }
}

struct PlacedSample {
    int x = 0, y = 0;
    XYZ value;
    float weight = 0.0f;
};

/// Samples [begin, end) of every pixel of 40 x 30, of very different sizes, each a function of its pixel and number.
std::vector<PlacedSample> wild_samples(int begin, int end) {
    std::vector<PlacedSample> samples;
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
            for (int i = begin; i < end; ++i) {
                Pcg32 random(static_cast<std::uint64_t>(y * 40 + x), static_cast<std::uint64_t>(i));
                const float size = std::ldexp(1.0f, static_cast<int>(random.next() % 80u) - 40);
                const bool is_bad = random.next() % 997u == 0;
                samples.push_back({x, y, XYZ{size * random.next_float(), is_bad ? -size : size, random.next_float()},
                                   random.next_float() < 0.1f ? -1.1f : 1.1f});
            }
        }
    }
    return samples;
}

/// Adds the samples to the film by tiles of a size.
void add_by_tiles(Film& film, const std::vector<PlacedSample>& samples, int tile_px) {
    const PixelBounds all = film.bounds();
    const int columns = (all.width() + tile_px - 1) / tile_px;
    std::vector<FilmTile> tiles;
    for (int y = 0; y < all.y1; y += tile_px) {
        for (int x = 0; x < all.x1; x += tile_px) {
            tiles.push_back(film.make_tile({x, y, std::min(x + tile_px, all.x1), std::min(y + tile_px, all.y1)}));
        }
    }
    for (const PlacedSample& sample : samples) {
        const int tile = sample.y / tile_px * columns + sample.x / tile_px;
        tiles[static_cast<std::size_t>(tile)].add(sample.x, sample.y, sample.value, sample.weight);
    }
    for (const FilmTile& tile : tiles) film.merge(tile);
}

void expect_same(const Film& film, const Film& expected) {
    EXPECT_EQ(film.xyz_image(), expected.xyz_image());
    EXPECT_EQ(film.sample_count(), expected.sample_count());
    const DroppedSamples dropped = film.dropped(), expected_dropped = expected.dropped();
    EXPECT_EQ(dropped.count(), expected_dropped.count());
    ASSERT_EQ(dropped.first().size(), expected_dropped.first().size());
    for (std::size_t i = 0; i < dropped.first().size(); ++i) {
        EXPECT_EQ(to_string(dropped.first()[i]), to_string(expected_dropped.first()[i]));
    }
}

TEST(FilmOrder, IsBitIdenticalForEverySizeOfTiles) {
    const std::vector<PlacedSample> samples = wild_samples(0, 21);
    Film expected(options(40, 30));
    add_by_tiles(expected, samples, 40);
    EXPECT_GT(expected.dropped().count(), 8u);
    for (const int tile_px : {1, 8, 16, 32, 64}) {
        Film film(options(40, 30));
        add_by_tiles(film, samples, tile_px);
        expect_same(film, expected);
    }
}

// Passes, runs and machines may end anywhere, not only where rounds of samples do.
TEST(FilmOrder, IsBitIdenticalForEverySplittingOfTheSamples) {
    Film expected(options(40, 30));
    add_by_tiles(expected, wild_samples(0, 21), 16);
    const std::vector<std::vector<int>> all_ends = {{1, 2, 4, 8, 16, 21}, {7, 14, 21}, {20, 21}, {3, 5, 6, 11, 21}};
    for (const std::vector<int>& ends : all_ends) {
        Film film(options(40, 30));
        int begin = 0;
        for (const int end : ends) {
            add_by_tiles(film, wild_samples(begin, end), 16);
            begin = end;
        }
        expect_same(film, expected);
    }
}

TEST(FilmOrder, IsBitIdenticalForEveryOrderOfSamples) {
    std::vector<PlacedSample> samples = wild_samples(0, 8);
    Film expected(options(40, 30));
    add_by_tiles(expected, samples, 16);
    std::mt19937 shuffler(7);
    for (int i = 0; i < 5; ++i) {
        std::shuffle(samples.begin(), samples.end(), shuffler);
        Film film(options(40, 30));
        add_by_tiles(film, samples, 16);
        expect_same(film, expected);
    }
}

TEST(FilmOrder, IsBitIdenticalOverEightThreads) {
    Film film(options(16, 12));
    const std::vector<FilmTile> tiles = wild_tiles(film);
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < 8; ++t) {
        threads.emplace_back([&film, &tiles, t] {
            for (std::size_t i = t; i < tiles.size(); i += 8) film.merge(tiles[i]);
            static_cast<void>(film.sample_count());
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(film.xyz_image(), merged(tiles));
    EXPECT_EQ(film.sample_count(), 40u * 500u);
}

}  // namespace
}  // namespace emulsion
