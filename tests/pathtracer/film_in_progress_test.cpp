// Shards, crop windows, resumed and interrupted renders: all the same picture, to the bit.

#include "pathtracer/film_in_progress.h"

#include <atomic>
#include <cmath>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pathtracer/render.h"
#include "pathtracer/scene_parser.h"

namespace emulsion::testing {
namespace {

using Contents = FilmContents<ExactSums>;

constexpr const char* kScene = R"(
LookAt 0 -5 3  0 0 0  0 0 1
Camera "perspective" "float fov" 40
WorldBegin
LightSource "infinite" "rgb L" [0.4 0.5 0.7] "float scale" 100
LightSource "point" "point3 from" [1 0 2] "blackbody I" [2800] "float scale" 500
Material "diffuse" "rgb reflectance" [0.7 0.4 0.2]
Shape "trianglemesh" "integer indices" [0 1 2 0 2 3] "point3 P" [-9 -9 0  9 -9 0  9 9 0  -9 9 0]
Shape "sphere" "float radius" 0.7
)";

const PreparedScene& scene() {
    static const PreparedScene prepared(parse_scene(kScene, "t.pbrt"), 1);
    return prepared;
}

FilmOptions with_everything(const Filter& filter, FilterUse use) {
    return {.width_px = 37,
            .height_px = 29,
            .filter = filter,
            .filter_use = use,
            .variance = FilmVariance::xyz,
            .spectrum = SpectralBuckets{.count = 3},
            .aux = known_aux_layers(),
            .firefly_control = MedianOfMeans{.groups = 3}};
}

Contents rendered(const FilmOptions& film_options, const RenderOptions& options) {
    Film film(film_options);
    RenderProgress progress;
    render(scene(), options, film, progress);
    return film.contents();
}

Contents resumed(const FilmOptions& film_options, const RenderOptions& options, Contents contents,
                 FilmProvenance provenance) {
    Film film(film_options, std::move(contents));
    FilmInProgress in_progress(film, std::move(provenance));
    RenderProgress progress;
    const std::int64_t missing = in_progress.missing_paths(samples_of(options));
    render(scene(), options, in_progress, progress);
    EXPECT_EQ(progress.samples_done, missing);
    EXPECT_EQ(in_progress.missing_paths(samples_of(options)), 0);
    return film.contents();
}

bool same_pixel(const Contents& a, std::size_t i, const Contents& b, std::size_t j) {
    const auto equal = [](auto x, auto y) { return std::equal(x.begin(), x.end(), y.begin(), y.end()); };
    return a.pixels[i] == b.pixels[j] && equal(a.channels.sums(i), b.channels.sums(j)) &&
           equal(a.channels.squares(i), b.channels.squares(j));
}

/// Pixels of `cut`, a film of these pixels only, that are not those of the full frame.
int differing_pixels(const Contents& cut, const PixelBounds& crop, const Contents& full, int width_px) {
    int differing = 0;
    std::size_t in_cut = 0;
    for (int y = crop.y0; y < crop.y1; ++y) {
        for (int x = crop.x0; x < crop.x1; ++x) {
            const auto in_full = static_cast<std::size_t>(y * width_px + x);
            differing += same_pixel(cut, in_cut++, full, in_full) ? 0 : 1;
        }
    }
    return differing;
}

TEST(RenderCrop, IsTheCutOfTheFullFrameForEveryFilterInBothUses) {
    const RenderOptions options{.samples_per_pixel = 3, .threads = 2};
    const PixelBounds crop{7, 5, 26, 18};
    std::vector<Filter> filters;
    for_each_alternative<Filter>([&](const auto& filter) { filters.emplace_back(filter); });
    for (const Filter& filter : filters) {
        for (const FilterUse use : {FilterUse::importance_sampled, FilterUse::splatted}) {
            FilmOptions film = with_everything(filter, use);
            const Contents full = rendered(film, options);
            film.crop = crop;
            const Contents cut = rendered(film, options);
            EXPECT_EQ(differing_pixels(cut, crop, full, film.width_px), 0)
                << to_text(filter) << " use " << static_cast<int>(use);
        }
    }
}

TEST(RenderThreads, EveryNumberGivesTheSameBitsOfEverything) {
    for (const FilterUse use : {FilterUse::importance_sampled, FilterUse::splatted}) {
        const FilmOptions film = with_everything(MitchellFilter{}, use);
        const Contents one = rendered(film, {.samples_per_pixel = 5, .threads = 1});
        for (const int threads : {2, 3, 8}) {
            EXPECT_TRUE(rendered(film, {.samples_per_pixel = 5, .threads = threads}) == one) << threads;
        }
    }
}

TEST(RenderShards, AddUpToTheSingleRun) {
    for (const FilterUse use : {FilterUse::importance_sampled, FilterUse::splatted}) {
        const FilmOptions film_options = with_everything(GaussianFilter{}, use);
        Film sum(film_options);
        for (const SampleRange& samples : {SampleRange{5, 7}, SampleRange{0, 2}, SampleRange{2, 5}}) {
            Film shard(film_options);
            RenderProgress progress;
            render(scene(), {.samples_per_pixel = 7, .samples = samples, .threads = 2}, shard, progress);
            EXPECT_EQ(progress.samples_done, static_cast<std::int64_t>(shard.sample_bounds().width()) *
                                                 shard.sample_bounds().height() *
                                                 static_cast<std::int64_t>(samples.size()));
            sum.merge(shard);
        }
        EXPECT_TRUE(sum.contents() == rendered(film_options, {.samples_per_pixel = 7}));
    }
}

// A round that was left in any of its tiles: what is there is made by hand, of pixels from films of fewer samples.
TEST(RenderResume, GoesOnFromAnyTilesOfARound) {
    FilmOptions film;
    film.width_px = 37;
    film.height_px = 29;
    const RenderOptions options{.samples_per_pixel = 12, .threads = 2};
    const Contents whole = rendered(film, options);
    const Contents four = rendered(film, {.samples_per_pixel = 4}), six = rendered(film, {.samples_per_pixel = 6});
    constexpr int kTile_px = 10;  // another size than the renderer's own
    const PixelBounds frame{0, 0, film.width_px, film.height_px};
    for (const unsigned mask : {0x001u, 0x5a5u, 0xffeu, 0xfffu, 0x000u}) {
        Contents contents = four;
        FilmProvenance provenance = provenance_of(scene().scene(), options);
        provenance.samples.add({0, 4});
        provenance.partial = PartialRound{{4, 6}, kTile_px, std::vector<std::uint8_t>(tile_count(frame, kTile_px))};
        ASSERT_EQ(provenance.partial->done.size(), 12u);
        for (std::size_t i = 0; i < 12; ++i) {
            if ((mask >> i & 1u) == 0) continue;
            provenance.partial->done[i] = 1;
            const PixelBounds tile = tile_bounds(frame, kTile_px, i);
            for (int y = tile.y0; y < tile.y1; ++y) {
                for (int x = tile.x0; x < tile.x1; ++x) {
                    const auto at = static_cast<std::size_t>(y * film.width_px + x);
                    contents.pixels[at] = six.pixels[at];
                    contents.counts.samples += 2;
                }
            }
        }
        EXPECT_TRUE(resumed(film, options, contents, provenance) == whole) << mask;
    }
}

// Copies that another thread takes while tiles come in belong together: from each the render ends up the same.
TEST(RenderResume, GoesOnFromCopiesTakenAtAnyMoment) {
    const FilmOptions film_options = with_everything(GaussianFilter{}, FilterUse::splatted);
    const RenderOptions options{.samples_per_pixel = 24, .threads = 2};
    Film film(film_options);
    FilmInProgress in_progress(film, provenance_of(scene().scene(), options));
    std::vector<std::pair<Contents, FilmProvenance>> copies;
    RenderProgress progress;
    std::atomic<bool> ended{false};
    std::thread copier([&] {
        const std::int64_t step = in_progress.missing_paths(samples_of(options)) / 6;
        for (std::int64_t next = step / 2; !ended; next = progress.samples_done + step) {
            while (progress.samples_done < next && !ended) std::this_thread::yield();
            copies.push_back(in_progress.read(
                [](const Film& f, const FilmProvenance& provenance) { return std::pair(f.contents(), provenance); }));
        }
    });
    render(scene(), options, in_progress, progress);
    ended = true;
    copier.join();
    const Contents whole = film.contents();
    ASSERT_FALSE(copies.empty());
    for (auto& [contents, provenance] : copies) {
        EXPECT_TRUE(resumed(film_options, options, std::move(contents), provenance) == whole);
    }
}

TEST(RenderResume, GoesOnToMoreSamplesThanWereAskedForFirst) {
    const FilmOptions film_options = with_everything(GaussianFilter{}, FilterUse::importance_sampled);
    Film film(film_options);
    FilmInProgress in_progress(film, provenance_of(scene().scene(), {.samples_per_pixel = 3}));
    RenderProgress progress;
    render(scene(), {.samples_per_pixel = 3}, in_progress, progress);
    render(scene(), {.samples_per_pixel = 8}, in_progress, progress);
    EXPECT_EQ(to_text(in_progress.provenance().samples), "0-8");
    EXPECT_TRUE(film.contents() == rendered(film_options, {.samples_per_pixel = 8}));
}

TEST(RenderResume, RefusesFilmsOfSomethingElse) {
    const RenderOptions options{.samples_per_pixel = 4};
    Film film({.width_px = 8, .height_px = 8});
    RenderProgress progress;
    FilmProvenance other_scene = provenance_of(scene().scene(), options);
    other_scene.scene = "another";
    FilmInProgress of_other_scene(film, other_scene);
    EXPECT_THROW(render(scene(), options, of_other_scene, progress), std::invalid_argument);
    FilmInProgress of_other_seed(film, provenance_of(scene().scene(), {.samples_per_pixel = 4, .seed = 1}));
    EXPECT_THROW(render(scene(), options, of_other_seed, progress), std::invalid_argument);
    FilmProvenance other_tiles = provenance_of(scene().scene(), options);
    other_tiles.partial = PartialRound{{0, 1}, 4, {1, 0, 1}};
    EXPECT_THROW(FilmInProgress(film, other_tiles), std::invalid_argument);
    EXPECT_EQ(film.sample_count(), 0u);
}

TEST(Provenance, TellsTotalsApartWhereTheSamplerDependsOnThem) {
    Scene stratified, independent;
    stratified.sampler = StratifiedSampler{};
    independent.sampler = IndependentSampler{};
    const RenderOptions few{.samples_per_pixel = 4}, many{.samples_per_pixel = 16};
    EXPECT_NE(provenance_of(stratified, few), provenance_of(stratified, many));
    EXPECT_EQ(provenance_of(independent, few), provenance_of(independent, many));
    EXPECT_THAT(provenance_of(stratified, many).sampling,
                ::testing::StartsWith("stratified:x=4,y=4,jitter=yes seed=0 model=spectral:4 renderer=emulsion-"));
}

/// Of each of 16 independent pictures.
std::vector<double> mean_luminances(const FilmOptions& film_options, std::uint64_t first_seed) {
    std::vector<double> means;
    for (std::uint64_t seed = first_seed; seed < first_seed + 16; ++seed) {
        Film film(film_options);
        RenderProgress progress;
        render(scene(), {.samples_per_pixel = 16, .seed = seed}, film, progress);
        double sum = 0.0;
        const Image<XYZ> picture = film.xyz_image();
        for (const XYZ& pixel : picture.pixels()) sum += static_cast<double>(pixel.y);
        means.push_back(sum / static_cast<double>(picture.pixels().size()));
    }
    return means;
}

// Student's t with 30 degrees of freedom exceeds 4.5 by chance once in 10,000.
TEST(RenderSplatted, HasTheMeanOfTheImportanceSampledPicture) {
    const auto moments = [](const std::vector<double>& values) {
        double mean = 0.0, squares = 0.0;
        for (const double value : values) mean += value / static_cast<double>(values.size());
        for (const double value : values) squares += (value - mean) * (value - mean);
        const auto n = static_cast<double>(values.size());
        return std::pair(mean, squares / (n * (n - 1.0)));
    };
    FilmOptions film{.width_px = 20, .height_px = 15, .filter = GaussianFilter{}};
    const auto [drawn, drawn_variance] = moments(mean_luminances(film, 100));
    film.filter_use = FilterUse::splatted;
    const auto [splatted, splatted_variance] = moments(mean_luminances(film, 200));
    const double standard_error = std::sqrt(drawn_variance + splatted_variance);
    EXPECT_NEAR(splatted, drawn, 4.5 * standard_error);
    EXPECT_LT(standard_error, 0.01 * drawn);
}

}  // namespace
}  // namespace emulsion::testing
