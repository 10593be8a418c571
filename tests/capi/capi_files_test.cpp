// Files that the C interface writes.

#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "capi/emulsion.h"
#include "capi_fixture.h"
#include "film/exr_file.h"
#include "support/temporary_folder.h"

namespace emulsion {
namespace {

using testing::add_in_c;
using testing::c_film;
using testing::c_tile;
using testing::FilmHandle;
using testing::kCount;
using testing::kXyzNumbers;
using testing::Samples;
using testing::TileHandle;

TEST(CapiFiles, AreThoseOfCpp) {
    const TemporaryFolder folder;
    const FilmHandle film = c_film();
    const TileHandle tile = c_tile(film);
    ASSERT_EQ(add_in_c(tile, Samples(4), 4), EMULSION_OK);
    ASSERT_EQ(emulsion_film_merge_tile(film.get(), tile.get()), EMULSION_OK);
    emulsion_exr_options options;
    ASSERT_EQ(emulsion_exr_options_init(&options, sizeof options), EMULSION_OK);
    options.renderer_version = "capi_test 1";
    ASSERT_EQ(emulsion_film_write_exr(film.get(), folder.file("c.exr").c_str(), &options, nullptr), EMULSION_OK);

    const FilmImage read = read_exr(folder.file("c.exr"));
    EXPECT_EQ(read.white_luminance_cdm2, 2.0);  // an imaging ratio of 0.5
    EXPECT_EQ(read.metadata.sample_count, kCount);
    EXPECT_EQ(read.metadata.renderer_version, "capi_test 1");
    std::vector<float> xyz(kXyzNumbers);
    ASSERT_EQ(emulsion_film_read_xyz(film.get(), xyz.data(), xyz.size()), EMULSION_OK);
    std::size_t i = 0;
    for (const XYZ& pixel : read.xyz.pixels()) {
        EXPECT_EQ(pixel, (XYZ{2.0f * xyz[i], 2.0f * xyz[i + 1], 2.0f * xyz[i + 2]}));
        i += 3;
    }
}

}  // namespace
}  // namespace emulsion
