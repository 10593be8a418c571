// Shards of a film, and what does not belong together.

#include <algorithm>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "film/film_state.h"
#include "film_state_fixture.h"

namespace emulsion {
namespace {

using emulsion::testing::every_film;
using emulsion::testing::NamedFilm;
using emulsion::testing::state_with;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const FilmOptions kPlain{.width_px = 5, .height_px = 4};

FilmState merged(const std::vector<FilmState>& shards) {
    FilmState state = shards.front();
    for (std::size_t i = 1; i < shards.size(); ++i) merge(state, shards[i]);
    return state;
}

TEST(FilmStateMerge, IsTheSingleRunInAThousandOrders) {
    for (const NamedFilm& film : every_film()) {
        const FilmState whole = state_with(film.options, 0, 12);
        std::vector<FilmState> shards;
        for (const auto& [begin, end] : {std::pair{0, 1}, {1, 4}, {4, 5}, {5, 9}, {9, 12}}) {
            shards.push_back(
                state_with(film.options, static_cast<std::uint64_t>(begin), static_cast<std::uint64_t>(end)));
        }
        std::mt19937 shuffler(1);
        for (int i = 0; i < 1000; ++i) {
            std::shuffle(shards.begin(), shards.end(), shuffler);
            ASSERT_TRUE(merged(shards) == whole) << film.name << ", shuffle " << i;
        }
    }
}

// As a tree of machines would do it, too.
TEST(FilmStateMerge, IsTheSingleRunForEveryGrouping) {
    const FilmOptions options = every_film()[1].options;
    FilmState a = state_with(options, 0, 3), b = state_with(options, 3, 4), c = state_with(options, 4, 8);
    const FilmState d = state_with(options, 8, 9);
    merge(c, d);
    merge(b, c);
    merge(a, b);
    EXPECT_TRUE(a == state_with(options, 0, 9));
}

TEST(FilmStateMerge, GapsStayGaps) {
    FilmState state = state_with(kPlain, 8, 10);
    merge(state, state_with(kPlain, 0, 3));
    EXPECT_EQ(to_text(state.provenance.samples), "0-3,8-10");
}

template <class... Words>
void expect_not_added(const FilmState& to, const FilmState& from, const Words&... words) {
    FilmState state = to;
    EXPECT_THAT([&] { merge(state, from); }, ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr(words)...)));
    EXPECT_TRUE(state == to);
}

/// That neither goes into the other, for a reason that holds all of `words`; and that nothing changes.
template <class... Words>
void expect_refused(const FilmState& a, const FilmState& b, const Words&... words) {
    expect_not_added(a, b, words...);
    expect_not_added(b, a, words...);
}

TEST(FilmStateMerge, FilmsOfOtherOptionsAreRefused) {
    const FilmState plain = state_with(kPlain, 0, 2);
    const auto changed = [](auto change) {
        FilmOptions options = kPlain;
        change(options);
        return state_with(options, 2, 4);
    };
    expect_refused(plain, changed([](FilmOptions& o) { o.width_px = 6; }), "size", "\"5x4\"", "\"6x4\"");
    expect_refused(plain, changed([](FilmOptions& o) {
                       o.crop = PixelBounds{0, 0, 5, 3};
                   }),
                   "crop", "[0, 5) x [0, 4)", "[0, 5) x [0, 3)");
    expect_refused(plain, changed([](FilmOptions& o) { o.filter = TriangleFilter{}; }), "filter is", "box", "triangle");
    expect_refused(plain, changed([](FilmOptions& o) { o.filter_use = FilterUse::splatted; }), "filter-use is",
                   "importance-sampled", "splatted");
    expect_refused(plain, changed([](FilmOptions& o) { o.light_splats = true; }), "light-splats", "no", "yes");
    expect_refused(plain, changed([](FilmOptions& o) { o.variance = FilmVariance::xyz; }), "variance", "none", "xyz");
    expect_refused(plain, changed([](FilmOptions& o) { o.spectrum = SpectralBuckets{}; }), "spectrum", "none",
                   "32:380-780");
    expect_refused(plain, changed([](FilmOptions& o) { o.aux = {known_aux_layer("depth")}; }), "aux", "none",
                   "depth:Z");
    expect_refused(plain, changed([](FilmOptions& o) { o.firefly_control = MedianOfMeans{}; }), "firefly-control",
                   "none", "median-of-means:groups=5");
    expect_refused(plain, changed([](FilmOptions& o) { o.sensor.iso = 200.0; }), "sensor", "iso=100", "iso=200");
    expect_refused(plain, changed([](FilmOptions& o) {
                       o.sensor.camera = CameraSensor{emulsion::testing::humps_camera(), {}};
                   }),
                   "sensor", "camera=none", ":humps");
}

// What a camera's file is called decides nothing: its curves do.
TEST(FilmStateMerge, ACameraIsItsCurves) {
    FilmOptions options = kPlain;
    options.sensor.camera = CameraSensor{emulsion::testing::humps_camera(), {}};
    FilmOptions renamed = options;
    renamed.sensor.camera->response.name = "elsewhere/copy of it: 2.csv";
    FilmState state = state_with(options, 0, 2);
    merge(state, state_with(renamed, 2, 4));
    EXPECT_TRUE(state.contents == state_with(options, 0, 4).contents);
    EXPECT_EQ(state.sensor_text, to_text(options.sensor));
    require_same_film(state, renamed, emulsion::testing::provenance(0, 4));

    FilmOptions other = renamed;
    other.sensor.camera->response.value[1].g *= 1.5;
    expect_refused(state, state_with(other, 4, 5), "sensor", ":humps", ":copy of it: 2.csv");
    EXPECT_EQ(without_camera_name("iso=100 camera=12ab:a b:c"), "iso=100 camera=12ab");
    EXPECT_EQ(without_camera_name("iso=100 camera=none"), "iso=100 camera=none");
}

TEST(FilmStateMerge, ACropWindowOfEverythingIsTheFullFrame) {
    FilmOptions cropped = kPlain;
    cropped.crop = bounds_of(kPlain);
    FilmState state = state_with(kPlain, 0, 2);
    merge(state, state_with(cropped, 2, 4));
    EXPECT_TRUE(state.contents == state_with(kPlain, 0, 4).contents);
}

TEST(FilmStateMerge, FilmsOfOtherOriginAreRefused) {
    const FilmState plain = state_with(kPlain, 0, 2);
    FilmState other = state_with(kPlain, 2, 4);
    other.provenance.scene = "ffff";
    expect_refused(plain, other, "scene", "\"scene 0123456789abcdef\"", "\"ffff\"");
    other.provenance.scene = "";
    expect_refused(plain, other, "scene", "\"scene 0123456789abcdef\"", "\"\"");
    other = state_with(kPlain, 2, 4);
    other.provenance.sampling = "seed 8";
    expect_refused(plain, other, "sampling", "seed 7", "seed 8");
}

TEST(FilmStateMerge, OverlapsAreRefused) {
    const FilmState plain = state_with(kPlain, 0, 3);
    expect_refused(plain, state_with(kPlain, 2, 4), "0-3", "2-4", "overlaps");
    expect_refused(plain, state_with(kPlain, 0, 3), "0-3", "overlaps");
    FilmState self = plain;
    EXPECT_THROW(merge(self, self), std::invalid_argument);
}

TEST(FilmStateMerge, PartialRoundsAreRefused) {
    FilmState partial = state_with(kPlain, 2, 4);
    partial.provenance.partial = PartialRound{{4, 20}, 2, {1, 0, 1, 1, 0, 0}};
    expect_refused(state_with(kPlain, 0, 2), partial, "partial round", "4-20", "3 of 6 tiles");
}

TEST(FilmStateMerge, WhatMayGoOnIsToldByTheSameRules) {
    const FilmOptions options = every_film()[1].options;
    const FilmState state = state_with(options, 0, 2);
    require_same_film(state, options, emulsion::testing::provenance(0, 2));
    FilmOptions other = options;
    other.sensor.camera->training.illuminant = BlackbodySpectrum{3200.0};
    EXPECT_THROW(require_same_film(state, other, state.provenance), std::invalid_argument);
    FilmProvenance elsewhere = state.provenance;
    elsewhere.scene = "other";
    EXPECT_THROW(require_same_film(state, options, elsewhere), std::invalid_argument);
}

TEST(FilmStateMerge, MetadataCountsEverything) {
    FilmState state = state_with(kPlain, 0, 2);
    const FilmState other = state_with(kPlain, 2, 9);
    const std::uint64_t samples = state.metadata.sample_count + other.metadata.sample_count;
    merge(state, other);
    EXPECT_EQ(state.metadata.sample_count, samples);
    EXPECT_EQ(state.metadata.sample_count, state.contents.counts.samples);
}

}  // namespace
}  // namespace emulsion
