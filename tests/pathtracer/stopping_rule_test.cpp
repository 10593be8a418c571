// Tiles that stop when they have enough samples.

#include "pathtracer/stopping_rule.h"

#include <cmath>
#include <set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pathtracer/film_in_progress.h"
#include "pathtracer/render.h"
#include "pathtracer/scene_parser.h"
#include "spectrum/ciede2000_difference.h"
#include "spectrum/viewing_conditions.h"

namespace emulsion::testing {
namespace {

using Contents = FilmContents<ExactSums>;

/// A coloured floor under a sky of two kinds of light, and a ball that shows the noise of indirect light.
constexpr const char* kScene = R"(
LookAt 0 -5 3  0 0 0  0 0 1
Camera "perspective" "float fov" 40
Sampler "independent"
WorldBegin
LightSource "infinite" "rgb L" [0.4 0.5 0.7] "float scale" 100
LightSource "point" "point3 from" [1 0 2] "blackbody I" [2800] "float scale" 500
Material "diffuse" "rgb reflectance" [0.7 0.4 0.2]
Shape "trianglemesh" "integer indices" [0 1 2 0 2 3] "point3 P" [-9 -9 0  9 -9 0  9 9 0  -9 9 0]
Shape "sphere" "float radius" 0.7
)";

constexpr int kWidth_px = 48, kHeight_px = 40;
constexpr FilmOptions film_options() { return {.width_px = kWidth_px, .height_px = kHeight_px}; }

const PreparedScene& scene() {
    static const PreparedScene prepared(parse_scene(kScene, "t.pbrt"), 2);
    return prepared;
}

RenderOptions until(double target, int samples_per_pixel = 1024) {
    return {.samples_per_pixel = samples_per_pixel, .threads = 2, .until = target};
}

Contents rendered(const RenderOptions& options) {
    Film film(film_options());
    RenderProgress progress;
    render(scene(), options, film, progress);
    return film.contents();
}

ViewingConditions viewing_of(const Image<XYZ>& picture) {
    double logs = 0.0, count = 0.0;
    for (const XYZ& pixel : picture.pixels()) {
        if (!(pixel.y > 0.0f)) continue;
        logs += std::log(static_cast<double>(pixel.y));
        count += 1.0;
    }
    return {default_white(observer("cie_1931_2deg")), white_luminance_of_log_average(std::exp(logs / count))};
}

double difference_of(const XYZ& a, const XYZ& b, const ViewingConditions& viewing) {
    const auto lab = [&](const XYZ& xyz) { return lab_as_viewed(XYZd{xyz.x, xyz.y, xyz.z}, viewing); };
    return difference(Ciede2000Difference{}, lab(a), lab(b));
}

/// Samples of each tile, all of whose pixels must have the same number.
std::vector<std::uint64_t> samples_of_tiles(const Contents& contents) {
    const PixelBounds frame{0, 0, kWidth_px, kHeight_px};
    std::vector<std::uint64_t> counts;
    for (std::size_t tile = 0; tile < tile_count(frame, kTileSize_px); ++tile) {
        const PixelBounds bounds = tile_bounds(frame, kTileSize_px, tile);
        std::set<std::uint64_t> of_pixels;
        for (int y = bounds.y0; y < bounds.y1; ++y) {
            for (int x = bounds.x0; x < bounds.x1; ++x) {
                of_pixels.insert(sums_of(contents, static_cast<std::size_t>(y * kWidth_px + x)).samples);
            }
        }
        EXPECT_EQ(of_pixels.size(), 1u) << "tile " << tile;
        counts.push_back(*of_pixels.begin());
    }
    return counts;
}

// The rule's estimate, of few samples that are thrown away, against the picture's real error.
TEST(StoppingRule, StopsAtTheErrorThatWasAskedFor) {
    Film reference_film(film_options()), film(film_options());
    RenderProgress progress;
    render(scene(), {.samples_per_pixel = 8192, .seed = 5, .threads = 2}, reference_film, progress);
    constexpr double kTarget = 1.5;
    render(scene(), until(kTarget), film, progress);
    const Image<XYZ> reference = reference_film.xyz_image(), picture = film.xyz_image();
    const ViewingConditions viewing = viewing_of(reference);

    const std::vector<std::uint64_t> counts = samples_of_tiles(film.contents());
    double all = 0.0;
    for (std::size_t tile = 0; tile < counts.size(); ++tile) {
        const PixelBounds bounds = tile_bounds({0, 0, kWidth_px, kHeight_px}, kTileSize_px, tile);
        double squares = 0.0;
        for (int y = bounds.y0; y < bounds.y1; ++y) {
            for (int x = bounds.x0; x < bounds.x1; ++x) {
                squares += std::pow(difference_of(reference(x, y), picture(x, y), viewing), 2);
            }
        }
        const double error = std::sqrt(squares / (static_cast<double>(bounds.width()) * bounds.height()));
        all += error / static_cast<double>(counts.size());
        EXPECT_LT(counts[tile], 1024u) << tile;
        // 256 pixels tell a variance within 9 % (one standard deviation), and what stops is soon below the target.
        EXPECT_LT(error, 1.3 * kTarget) << tile << " of " << counts[tile];
        if (counts[tile] > StoppingRule::kFirstLook) {
            EXPECT_GT(error, 0.7 * kTarget) << tile << " of " << counts[tile];
        }
    }
    // The worse of a tile and its surroundings counts.
    EXPECT_LT(all, kTarget);
    EXPECT_GT(all, 0.75 * kTarget);
    EXPECT_GT(std::set<std::uint64_t>(counts.begin(), counts.end()).size(), 2u);
}

TEST(StoppingRule, LowerTargetsTakeMoreSamplesAsTheSquare) {
    const auto mean = [](double target) {
        double sum = 0.0;
        const std::vector<std::uint64_t> counts = samples_of_tiles(rendered(until(target, 4096)));
        for (const std::uint64_t count : counts) sum += static_cast<double>(count);
        return sum / static_cast<double>(counts.size());
    };
    EXPECT_NEAR(mean(0.75) / mean(1.5), 4.0, 0.6);
}

TEST(StoppingRule, StopsSoonWhereThereIsNoNoiseAndNeverWhereTheTargetIsTooLow) {
    for (const std::uint64_t count : samples_of_tiles(rendered(until(1000.0, 80)))) EXPECT_EQ(count, 64u);
    EXPECT_TRUE(rendered(until(1e-9, 80)) == rendered({.samples_per_pixel = 80, .threads = 2}));
    // Fewer than there are looks after.
    EXPECT_TRUE(rendered(until(1000.0, 40)) == rendered({.samples_per_pixel = 40, .threads = 2}));
}

TEST(StoppingRule, EveryNumberOfThreadsGivesTheSameBits) {
    RenderOptions options = until(3.0, 256);
    const Contents two = rendered(options);
    for (const int threads : {1, 5}) {
        options.threads = threads;
        EXPECT_TRUE(rendered(options) == two) << threads;
    }
}

// A render that was stopped anywhere, and one that was asked for fewer samples first, ends up the same.
TEST(StoppingRule, GoesOnToWhatASingleRunGives) {
    const RenderOptions options = until(3.0, 256);
    const Contents whole = rendered(options);
    for (const int first : {7, 40, 72, 100}) {
        Film film(film_options());
        FilmInProgress in_progress(film, provenance_of(scene().scene(), options));
        RenderProgress progress;
        render(scene(), until(3.0, first), in_progress, progress);
        Film rest(film_options(), film.contents());
        FilmInProgress rest_in_progress(rest, in_progress.provenance());
        render(scene(), options, rest_in_progress, progress);
        EXPECT_TRUE(rest.contents() == whole) << first;
        EXPECT_EQ(rest_in_progress.missing_paths(samples_of(options)), 0);
    }
}

/// Light that most paths miss: the pair's pixels are black or far too bright, and no look may take that for quiet.
TEST(StoppingRule, IsNotFooledWhereMostPathsFindNoLight) {
    Scene room = read_scene(EMULSION_SOURCE_DIR "/scenes/sunlit-room.pbrt");
    room.film.width_px = 32;
    room.film.height_px = 24;
    room.sampler = IndependentSampler{};
    const PreparedScene prepared(std::move(room), 2);
    const auto picture = [&](const RenderOptions& options) {
        Film film(film_options(prepared.scene()));
        RenderProgress progress;
        render(prepared, options, film, progress);
        return film.xyz_image();
    };
    const Image<XYZ> reference = picture({.samples_per_pixel = 4096, .seed = 3, .threads = 2});
    double sum = 0.0;
    const ViewingConditions viewing = viewing_of(reference);
    const Image<XYZ> stopped = picture(until(8.0, 2048));
    for (std::size_t i = 0; i < stopped.pixels().size(); ++i) {
        sum += std::pow(difference_of(reference.pixels()[i], stopped.pixels()[i], viewing), 2);
    }
    // It was 20 when each pixel of the pair was looked at on its own.
    EXPECT_NEAR(std::sqrt(sum / static_cast<double>(stopped.pixels().size())), 8.0, 2.0);
}

TEST(StoppingRule, NeverStopsWhatIsTooSmallToTell) {
    for (const int side_px : {1, 7, 8}) {
        StoppingRule rule({.width_px = side_px, .height_px = side_px}, 1000.0, kTileSize_px);
        for (Film* film : {&rule.first(), &rule.second()}) {
            FilmTile tile = film->make_tile({0, 0, side_px, side_px});
            for (int y = 0; y < side_px; ++y) {
                for (int x = 0; x < side_px; ++x) tile.add(x, y, XYZ{1.0f, 1.0f, 1.0f}, 1.0f);
            }
            film->merge(tile);
        }
        rule.look(64, 1);
        EXPECT_EQ(rule.running_tiles().empty(), side_px == 8) << side_px;
    }
}

TEST(StoppingRule, CountsThePathsThatItSaves) {
    const RenderOptions options = until(3.0, 256);
    Film film(film_options());
    FilmInProgress in_progress(film, provenance_of(scene().scene(), options));
    RenderProgress progress;
    const std::int64_t missing = in_progress.missing_paths(samples_of(options));
    render(scene(), options, in_progress, progress);
    EXPECT_EQ(progress.samples_done + progress.samples_saved, missing);
    EXPECT_EQ(static_cast<std::uint64_t>(progress.samples_done), film.sample_count());
    EXPECT_GT(progress.samples_saved, 0);
    EXPECT_EQ(in_progress.tiles_left_out(), 9u);
}

TEST(StoppingRule, RefusesWhatItCannotStop) {
    const auto message = [](const FilmOptions& film_is, const RenderOptions& options) -> std::string {
        Film film(film_is);
        RenderProgress progress;
        try {
            render(scene(), options, film, progress);
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return {};
    };
    using ::testing::StartsWith;
    EXPECT_THAT(message(film_options(), until(0.0)), StartsWith("until 0: must be"));
    EXPECT_THAT(message(film_options(), until(-1.0)), StartsWith("until -1: must be"));
    EXPECT_THAT(message(film_options(), until(std::nan(""))), StartsWith("until nan: must be"));
    FilmOptions splatted = film_options();
    splatted.filter_use = FilterUse::splatted;
    EXPECT_THAT(message(splatted, until(1.0)), StartsWith("filter_use splatted: must be importance_sampled"));
    RenderOptions share = until(1.0, 64);
    share.samples = SampleRange{0, 32};
    EXPECT_THAT(message(film_options(), share), StartsWith("samples [0, 32): must be all"));
}

TEST(StoppingRule, IsPartOfTheProvenance) {
    const FilmProvenance with = provenance_of(scene().scene(), until(1.5));
    EXPECT_THAT(with.sampling, ::testing::HasSubstr(" until=1.5 "));
    EXPECT_TRUE(stops_by_tile(with));
    EXPECT_FALSE(stops_by_tile(provenance_of(scene().scene(), {})));
    FilmProvenance taken = with;
    taken.samples.add({0, 32});
    EXPECT_EQ(samples_taken(taken), (SamplesTaken{0, 0}));
}

TEST(FilmInProgress, LeavesOutAsManyTilesAsThereAre) {
    Film film(film_options());
    FilmInProgress in_progress(film, {});
    EXPECT_THROW(in_progress.leave_out(std::vector<std::uint8_t>(8)), std::invalid_argument);
    in_progress.leave_out({1, 1, 1, 1, 0, 1, 1, 1, 1});
    EXPECT_EQ(in_progress.tiles_left_out(), 8u);
    EXPECT_EQ(in_progress.missing_paths({0, 10}), 256 * 10);
    EXPECT_THAT(in_progress.next_round({0, 10})->tiles, ::testing::ElementsAre(4u));
    in_progress.leave_out(std::vector<std::uint8_t>(9, 1));
    EXPECT_FALSE(in_progress.next_round({0, 10}));
    EXPECT_EQ(in_progress.missing_paths({0, 10}), 0);
}

}  // namespace
}  // namespace emulsion::testing
