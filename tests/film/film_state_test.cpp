// Film states: what is read is what was written, to the bit, and a film goes on as if it had never stopped.

#include "film/film_state.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>

#include "exr_fixture.h"
#include "film/film_layers.h"
#include "film/film_metadata.h"
#include "film_state_fixture.h"

namespace emulsion {
namespace {

using emulsion::testing::add_samples;
using emulsion::testing::every_film;
using emulsion::testing::NamedFilm;
using emulsion::testing::provenance;
using emulsion::testing::state_with;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using FilmStateFile = ExrFile;

TEST_F(FilmStateFile, EveryKindOfFilmComesBackBitForBit) {
    std::uint64_t faint = 0;
    for (const NamedFilm& film : every_film()) {
        const FilmState state = state_with(film.options, 0, 5);
        EXPECT_GT(state.contents.counts.dropped.count(), 2u) << film.name << " is too tame";
        faint += state.contents.counts.faint;
        write_film_state(file("a.film.exr"), state);
        EXPECT_TRUE(is_film_state(file("a.film.exr")));
        const FilmState read = read_film_state(file("a.film.exr"));
        EXPECT_TRUE(read == state) << film.name;
        EXPECT_EQ(read.sensor_text, to_text(film.options.sensor));
        EXPECT_EQ(read.options.crop, film.options.crop);
    }
    EXPECT_GT(faint, 10u) << "they are too bright";
}

TEST_F(FilmStateFile, EmptySaturatedAndUnfinishedFilmsComeBack) {
    FilmState state = state_with({.width_px = 3, .height_px = 2}, 0, 0);
    write_film_state(file("empty.film.exr"), state);
    EXPECT_TRUE(read_film_state(file("empty.film.exr")) == state) << "a film without samples";

    Film film({.width_px = 3, .height_px = 2, .variance = FilmVariance::xyz});
    FilmTile tile = film.make_tile(film.bounds());
    for (int i = 0; i < 9; ++i) {
        tile.add(1, 1, XYZ{1e30f, 3e38f, 1e30f}, 3e38f);
        tile.add(2, 0, XYZ{1e30f, 3e38f, 1e30f}, -3e38f);
    }
    film.merge(tile);
    EXPECT_EQ(film.saturated_pixels(), 2);
    state = state_of(film, provenance(0, 9), {});
    state.provenance.samples.add(SampleRange{1u << 31u, ~std::uint64_t{0}});
    for (const std::size_t tiles : {1u, 4u, 5u, 8u, 131u}) {
        state.provenance.partial = PartialRound{{16, 32}, 64, std::vector<std::uint8_t>(tiles, 1)};
        state.provenance.partial->done[tiles / 2] = 0;
        write_film_state(file("a.film.exr"), state);
        EXPECT_TRUE(read_film_state(file("a.film.exr")) == state) << tiles;
    }
}

TEST_F(FilmStateFile, GoesOnAsIfItHadNeverStopped) {
    for (const NamedFilm& named : every_film()) {
        Film whole(named.options);
        add_samples(whole, 0, 7);
        write_film_state(file("a.film.exr"), state_with(named.options, 0, 3));
        FilmState state = read_film_state(file("a.film.exr"));
        require_same_film(state, named.options, provenance(0, 0));
        Film film(named.options, std::move(state.contents));
        add_samples(film, 3, 7);
        EXPECT_TRUE(film.contents() == whole.contents()) << named.name;
    }
}

// To whoever knows nothing of states it is the picture, with the same layers and the same header.
TEST_F(FilmStateFile, IsThePictureToOtherReaders) {
    for (const NamedFilm& named : every_film()) {
        for (const ExrOptions& options : {ExrOptions{}, ExrOptions{.space = "sRGB", .pixel_type = PixelType::half}}) {
            const FilmState state = state_with(named.options, 0, 4);
            const ExrWriteResult result = write_film_state(file("a.film.exr"), state, options);
            Film film(named.options);
            add_samples(film, 0, 4);
            ExrOptions picture_options = options;
            picture_options.white_luminance_cdm2 = white_luminance_cdm2(named.options.sensor);
            EXPECT_EQ(write_exr(file("b.exr"), picture_of(film), state.metadata, picture_options), result);
            const FilmImage read = read_exr(file("a.film.exr")), expected = read_exr(file("b.exr"));
            EXPECT_THAT(read.notes, IsEmpty());
            EXPECT_TRUE(static_cast<const FilmPicture&>(read) == expected) << named.name;
            EXPECT_EQ(read.metadata, expected.metadata);
            EXPECT_EQ(read.white_luminance_cdm2, expected.white_luminance_cdm2);
        }
    }
    EXPECT_FALSE(is_film_state(file("b.exr")));
}

/// A channel of the sums.
std::vector<std::uint32_t> words(const fs::path& path, const std::string& name, int pixels) {
    std::vector<std::uint32_t> values(static_cast<std::size_t>(pixels));
    Imf::MultiPartInputFile file(path.c_str());
    Imf::InputPart part(file, 1);
    EXPECT_EQ(part.header().channels()[name].type, Imf::UINT);
    Imf::FrameBuffer places;
    places.insert(name, Imf::Slice::Make(Imf::UINT, values.data(), part.header().dataWindow()));
    part.setFrameBuffer(places);
    part.readPixels(part.header().dataWindow().min.y, part.header().dataWindow().max.y);
    return values;
}

// What a cluster's own tools would add up: plain two's complement numbers.
TEST_F(FilmStateFile, SumsAreWholeNumbersByNames) {
    Film film({.width_px = 2, .height_px = 1, .light_splats = true, .variance = FilmVariance::luminance});
    FilmTile tile = film.make_tile(film.bounds());
    tile.add(0, 0, XYZ{0x1p-44f, 3.0f, 0.0f}, 1.0f);
    tile.add(1, 0, XYZ{-0x1p-44f, 0x1p10f, 5.0f}, 2.0f);
    tile.add(1, 0, XYZ{0.0f, 0.0f, 0.0f}, -0.5f);
    film.merge(tile);
    write_film_state(file("a.film.exr"), state_of(film, {}, {}));
    const auto channel = [&](const char* name) { return words(file("a.film.exr"), name, 2); };
    EXPECT_THAT(channel("X.0"), ElementsAre(1u, 0xfffffffeu));
    EXPECT_THAT(channel("X.1"), ElementsAre(0u, 0xffffffffu));
    EXPECT_THAT(channel("X.2"), ElementsAre(0u, 0xffffffffu));
    EXPECT_THAT(channel("Y.1"), ElementsAre(3u << 12u, 2u << 22u));
    EXPECT_THAT(channel("Z.1"), ElementsAre(0u, 10u << 12u));
    EXPECT_THAT(channel("weight.0"), ElementsAre(1u << 30u, 3u << 29u));
    EXPECT_THAT(channel("weight.1"), ElementsAre(0u, 0u));
    EXPECT_THAT(channel("samples"), ElementsAre(1u, 2u));
    EXPECT_THAT(channel("sum.00002.2"), ElementsAre(0u, 0u));
    EXPECT_THAT(channel("square.0.2"), ElementsAre(0u, 1u << (1 + 20 + 60 - 64)));
    EXPECT_THAT(channel("square.0.1"), ElementsAre(9u << 28u, 0u));
}

TEST_F(FilmStateFile, AllCompressionsKeepTheSums) {
    const FilmState state = state_with(every_film()[1].options, 0, 3);
    for_each_alternative<ExrCompression>([&](const auto& compression) {
        write_film_state(file("a.film.exr"), state, {.compression = compression});
        EXPECT_TRUE(read_film_state(file("a.film.exr")) == state) << compression.kName;
    });
}

TEST_F(FilmStateFile, IsTheSameForEveryNumberOfThreads) {
    const FilmState state = state_with({.width_px = 70, .height_px = 90}, 0, 1);
    write_film_state(file("a.film.exr"), state, {.threads = 1});
    write_film_state(file("b.film.exr"), state, {.threads = 8});
    EXPECT_EQ(read_text(file("a.film.exr")), read_text(file("b.film.exr")));
}

TEST_F(FilmStateFile, MetadataFollowsFromTheFilm) {
    const FilmState state = state_with(every_film()[1].options, 0, 5);
    const FilmCounts& counts = state.contents.counts;
    EXPECT_EQ(state.metadata.sample_count, counts.samples);
    EXPECT_EQ(state.metadata.samples_per_pixel, 5);
    EXPECT_EQ(state.metadata.dropped_nan_count, counts.dropped.count(DroppedKind::nan));
    EXPECT_EQ(state.metadata.faint_count, counts.faint);
    EXPECT_EQ(state.metadata.seed, 7u);
    EXPECT_EQ(state.metadata.command_line, "a 'b c'");
    EXPECT_THAT(state.metadata.filter, HasSubstr("mitchell:"));
    EXPECT_THAT(state.metadata.film, HasSubstr("variance=xyz"));
    EXPECT_THAT(state.metadata.film, HasSubstr("observer=cie-1964-10deg"));
    EXPECT_THAT(state.metadata.firefly_control, HasSubstr("clamp:luminance=3.1; "));
}

TEST_F(FilmStateFile, ABadStateIsRefusedBeforeAnythingIsWritten) {
    FilmState state = state_with({.width_px = 3, .height_px = 2}, 0, 1);
    state.contents.pixels.pop_back();
    EXPECT_THROW(write_film_state(file("a.film.exr"), state), std::invalid_argument);
    state = state_with({.width_px = 3, .height_px = 2}, 0, 1);
    state.options.width_px = 0;
    EXPECT_THROW(write_film_state(file("a.film.exr"), state), std::invalid_argument);
    state = state_with({.width_px = 3, .height_px = 2, .light_splats = true}, 0, 1);
    state.contents.counts.light_paths = 0;
    EXPECT_THROW(write_film_state(file("a.film.exr"), state), std::logic_error);
    EXPECT_EQ(files_in_folder(), 0u);
    EXPECT_THAT([&] { write_film_state(file("none/a.film.exr"), state_with({.width_px = 1, .height_px = 1}, 0, 1)); },
                throws_io_error(file("none/a.film.exr")));
}

}  // namespace
}  // namespace emulsion
