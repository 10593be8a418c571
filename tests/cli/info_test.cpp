// `emulsion info`: what an EXR is and what is in it, for people and for machines.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "film/exr_file.h"
#include "film_states.h"
#include "json_check.h"
#include "run_program.h"
#include "support/temporary_folder.h"

namespace emulsion::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class InfoProgram : public ::testing::Test {
  protected:
    [[nodiscard]] std::string text_of(const std::string& path) const {
        const ProgramResult result = run_program({"info", path});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(result.err, "");
        return result.out;
    }
    [[nodiscard]] std::string json_of(const std::string& path) const {
        const ProgramResult result = run_program({"info", path, "--json"});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_TRUE(JsonCheck::is_json(result.out)) << result.out;
        return result.out;
    }

    TemporaryFolder folder_;
    const std::string exr_ = folder_.file("a.exr"), state_ = folder_.file("a.film.exr");
};

TEST_F(InfoProgram, TellsAboutFilmStates) {
    FilmOptions options = small_film();
    options.crop = PixelBounds{2, 1, 12, 7};
    options.aux = {known_aux_layer("albedo")};
    FilmState state = film_state(options, 0, 3);
    state.provenance.samples.add(SampleRange{16, 20});
    state.provenance.partial = PartialRound{{32, 64}, 4, {1, 0, 1, 1, 0, 0}};
    write_film_state(state_, state, {.space = "sRGB", .pixel_type = PixelType::half});
    EXPECT_THAT(
        text_of(state_),
        AllOf(
            HasSubstr("film state, "), HasSubstr("10x6 pixels, [2, 12) x [1, 7) of the frame [0, 12) x [0, 8)"),
            HasSubstr("R G B, linear sRGB, 16-bit floats"), HasSubstr("white luminance  2 cd/m^2\n"),
            HasSubstr("albedo (B G R), samples, standard-error (Y), variance (Y)\n"),
            HasSubstr("samples          7 to 39 of each pixel, 179 in all\n                 2 to 3 reach each pixel\n"),
            HasSubstr("1 NaN, 0 infinite, 0 of negative luminance\n"), HasSubstr("  pixel (3, 2): XYZ ("),
            HasSubstr("sample ranges    0-3,16-20\n"), HasSubstr("partial round    32-64, in 3 of 6 tiles\n"),
            HasSubstr("scene            cafe0123\n"), HasSubstr("firefly control  none\n"),
            HasSubstr("command line     render it\n")));
    EXPECT_THAT(
        json_of(state_),
        AllOf(HasSubstr("\"kind\": \"film state\""), HasSubstr("\"data_window\": [2, 1, 12, 7]"),
              HasSubstr("\"samples_per_pixel\": 3,"), HasSubstr("\"most_samples_per_pixel\": 39,"),
              HasSubstr("\"fewest_samples_reaching_a_pixel\": 2,"), HasSubstr("\"most_samples_reaching_a_pixel\": 3,"),
              HasSubstr("\"dropped\": {\"nan\": 1, \"infinite\": 0, \"negative_luminance\": 0}"),
              HasSubstr("\"sample_ranges\": [[0, 3], [16, 20]]"),
              HasSubstr("\"partial_round\": {\"begin\": 32, \"end\": 64, \"tiles\": 6, \"done\": 3}")));
}

TEST_F(InfoProgram, TellsAboutFilmPictures) {
    Image<XYZ> picture(3, 2);
    for (XYZ& pixel : picture.pixels()) pixel = {1.0f, 1.0f, 1.0f};
    picture(0, 0).y = 4.0f;
    picture(1, 0).y = 0.0f;
    picture(2, 0).y = -1.0f;
    picture(0, 1).y = 2.0f;
    write_exr(exr_, picture,
              {.samples_per_pixel = 5, .sample_count = 31, .faint_count = 4, .seed = 9, .filter = "box:x-radius=0.5"},
              {.white_luminance_cdm2 = 8.0});
    EXPECT_THAT(text_of(exr_),
                AllOf(HasSubstr("film picture, "), HasSubstr("size             3x2 pixels\n"),
                      HasSubstr("X Y Z, 32-bit floats"), HasSubstr("luminance        8 to 32 cd/m^2\n"),
                      HasSubstr("dynamic range    2.0 zones\n"),
                      HasSubstr("log-average      13.4543 cd/m^2\n"),  // 8 (4 * 1 * 1 * 2)^(1/4)
                      HasSubstr("left out: 1 pixel of luminance 0\n"), HasSubstr("left out: 1 pixel of negative"),
                      HasSubstr("at least 5 of each pixel, 31 in all\n"), HasSubstr("dropped          none\n"),
                      HasSubstr("too faint        4\n")));
    EXPECT_THAT(json_of(exr_), AllOf(HasSubstr("\"kind\": \"film picture\""), HasSubstr("\"min_positive_cdm2\": 8,"),
                                     HasSubstr("\"log_average_cdm2\": 13.4543"),
                                     HasSubstr("\"dynamic_range_zones\": 2,"), HasSubstr("\"zero_pixels\": 1,"),
                                     HasSubstr("\"negative_pixels\": 1,"), HasSubstr("\"faint\": 4,")));
}

// Channels X Y and Q: no picture that we know.
TEST_F(InfoProgram, TellsWhatItCanOfOtherFiles) {
    write_exr(exr_, Image<XYZ>(4, 2), {});
    std::string bytes = read_text(exr_);
    bytes[bytes.find(std::string("Z\0", 2), bytes.find("chlist"))] = 'Q';
    write_text(exr_, bytes);
    EXPECT_THAT(text_of(exr_),
                AllOf(HasSubstr("other EXR, "), HasSubstr("4x2 pixels\n"), HasSubstr("channels     Q, X, Y\n")));
    EXPECT_THAT(json_of(exr_), AllOf(HasSubstr("\"kind\": \"other EXR\""), Not(HasSubstr("luminance"))));
}

TEST_F(InfoProgram, WhatFilesSayDoesNoHarm) {
    write_exr(exr_, Image<XYZ>(1, 1), {.renderer_version = "a\nb\x1b[31m\"c\"", .command_line = "d\xff\\"});
    EXPECT_THAT(text_of(exr_), AllOf(HasSubstr("renderer         a b [31m\"c\"\n"), Not(HasSubstr("\x1b")),
                                     HasSubstr("luminance        no pixel has any\n")));
    EXPECT_THAT(json_of(exr_), HasSubstr("\"renderer\": \"a\\u000ab\\u001b[31m\\\"c\\\"\""));
}

TEST_F(InfoProgram, DamagedAndOtherFilesAreErrors) {
    const auto expect_error = [](const std::string& path, const std::string& words) {
        const ProgramResult result = run_program({"info", path});
        EXPECT_EQ(result.exit_code, 1);
        EXPECT_EQ(result.out, "");
        EXPECT_THAT(result.err, AllOf(StartsWith("emulsion: error: " + path), HasSubstr(words)));
    };
    write_text(exr_, "no EXR at all");
    expect_error(exr_, "is not an EXR file");
    expect_error(folder_.file("none.exr"), "No such file");
    write_film_state(state_, film_state(small_film(), 0, 2));
    std::string bytes = read_text(state_);
    bytes[bytes.size() - 9] = static_cast<char>(bytes[bytes.size() - 9] ^ 4);
    write_text(state_, bytes);
    expect_error(state_, "damaged");
}

}  // namespace
}  // namespace emulsion::testing
