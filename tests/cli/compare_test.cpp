// `emulsion compare`: two pictures, files or scenes, and how far they are apart.

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "display/png_file.h"
#include "display/png_read.h"
#include "film/exr_file.h"
#include "film/film_layers.h"
#include "film_states.h"
#include "json_check.h"
#include "run_program.h"
#include "scenes.h"
#include "support/temporary_folder.h"

namespace emulsion::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class CompareProgram : public ::testing::Test {
  protected:
    /// A picture of greys of D65.
    std::string write_grey(const std::string& name, float luminance, int width = 8, int height = 6) const {
        Image<XYZ> image(width, height);
        for (XYZ& pixel : image.pixels()) pixel = luminance * XYZ{0.3127f / 0.3290f, 1.0f, 0.3583f / 0.3290f};
        (void)write_exr(folder_.file(name), image, {});
        return folder_.file(name);
    }

    static ProgramResult compare(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "compare");
        return run_program(arguments);
    }

    /// What stands behind "key": in the JSON.
    static double number(const std::string& json, const std::string& key) {
        const std::size_t at = json.find("\"" + key + "\": ");
        EXPECT_NE(at, std::string::npos) << key << " in " << json;
        return at == std::string::npos ? NAN : std::strtod(json.c_str() + at + key.size() + 4, nullptr);
    }

    TemporaryFolder folder_;
};

// The greys have 18 % and 9 % of white: L* 49.4961 and 35.9843, so CIEDE2000 is 13.5118 / S_L at 42.7402, which is
// 1 + 0.015 * 7.2598^2 / sqrt(20 + 7.2598^2) = 1.09272; relative MSE 0.09^2 / (0.18^2 + 0.01).
TEST_F(CompareProgram, SaysHowFarPicturesAreApart) {
    const std::string a = write_grey("a.exr", 36.0f), b = write_grey("b.exr", 18.0f);
    const ProgramResult result = compare({a, b});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_THAT(result.out,
                AllOf(HasSubstr("A, the reference  " + a + "\n"), HasSubstr("compared          8x6 pixels\n"),
                      HasSubstr("200 cd/m^2 (A's log-average is 18 % of it), x 0.3127, y 0.3290\n"),
                      HasSubstr("CIEDE2000         mean 12.37    p50 12.37    p99 12.37    max 12.37 at 0, 0\n"),
                      HasSubstr("relative MSE      0.191\n"), HasSubstr("dB, tone-mapped and encoded\n"),
                      HasSubstr("due to noise      unknown: A and B have no layers standard-error")));
    const ProgramResult json = compare({a, b, "--json"});
    EXPECT_TRUE(JsonCheck::is_json(json.out)) << json.out;
    EXPECT_THAT(json.out, AllOf(HasSubstr("\"noise_and_bias\": null"), HasSubstr("\"window\": [0, 0, 8, 6]")));
    EXPECT_NEAR(number(json.out, "mean"), 12.3653, 1e-4);
    EXPECT_NEAR(number(json.out, "relative_mse"), 0.0081 / 0.0424, 1e-5);
    EXPECT_NEAR(number(json.out, "luminance_cdm2"), 200.0, 1e-4);
}

TEST_F(CompareProgram, WhiteIsAsTold) {
    const std::string a = write_grey("a.exr", 36.0f), b = write_grey("b.exr", 18.0f);
    const std::string given = compare({a, b, "--white-luminance", "36", "--white", "A", "--json"}).out;
    EXPECT_EQ(number(given, "luminance_cdm2"), 36.0);
    EXPECT_NEAR(number(given, "x"), 0.4476, 1e-4);
    EXPECT_NEAR(number(given, "relative_mse"), 0.25 / 1.01, 1e-6);
    EXPECT_THAT(compare({a, b, "--white", "0.3,0.32"}).out, HasSubstr("x 0.3000, y 0.3200"));
}

TEST_F(CompareProgram, EqualPicturesAreEqual) {
    const std::string a = write_grey("a.exr", 36.0f);
    const ProgramResult result = compare({a, a, "--fail-above", "0,0"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, AllOf(HasSubstr("max 0 at 0, 0\n"), HasSubstr("PSNR              infinite")));
    EXPECT_THAT(compare({a, a, "--json"}).out, HasSubstr("\"psnr_db\": null"));
}

TEST_F(CompareProgram, ExitsWithOneAboveTheLimits) {
    const std::string a = write_grey("a.exr", 36.0f), b = write_grey("b.exr", 18.0f);
    EXPECT_EQ(compare({a, b, "--fail-above", "12.4"}).exit_code, 0);
    const ProgramResult above = compare({a, b, "--fail-above", "12.3", "--json"});
    EXPECT_EQ(above.exit_code, 1);
    EXPECT_THAT(above.out, HasSubstr("\"within_limits\": false"));
    EXPECT_EQ(above.err, "emulsion: error: the mean of CIEDE2000 is 12.37, above 12.3\n");
    EXPECT_THAT(compare({a, b, "--fail-above", "13,12"}).err, HasSubstr("the 99th percentile of CIEDE2000 is 12.37"));

    Image<XYZ> broken(8, 6);
    for (XYZ& pixel : broken.pixels()) pixel = {34.2f, 36.0f, 39.2f};
    broken(3, 2).x = NAN;
    (void)write_exr(b, broken, {});
    const ProgramResult nan = compare({a, b, "--fail-above", "50"});
    EXPECT_EQ(nan.exit_code, 1);
    EXPECT_THAT(nan.err, HasSubstr("1 pixel finite in A and not in B"));
    EXPECT_THAT(nan.out, HasSubstr("left out          1 pixel of both, the first at 3, 2\n"));
    EXPECT_EQ(compare({b, a, "--fail-above", "50"}).exit_code, 0);
}

TEST_F(CompareProgram, DrawsAMap) {
    const std::string a = write_grey("a.exr", 36.0f), b = write_grey("b.exr", 18.0f), map = folder_.file("map.png");
    EXPECT_EQ(compare({a, b, "--map", map}).exit_code, 0);
    const PngPicture picture = read_png(map);
    EXPECT_GT(picture.xyz.width(), 150);
    EXPECT_GT(picture.xyz.height(), 6 + 40);
    const float default_end = picture.xyz(4, 4).y;
    EXPECT_EQ(compare({a, b, "--map", map, "--map-end", "12"}).exit_code, 0);
    EXPECT_GT(read_png(map).xyz(4, 4).y, 1.2f * default_end);
}

TEST_F(CompareProgram, TakesPicturesOfAllFormats) {
    const std::string exr = write_grey("a.exr", 0.5f), png = folder_.file("b.png");
    ASSERT_EQ(run_program({"develop", exr, "-o", png, "--tonemap", "fixed:white=1", "--bits", "16"}).exit_code, 0);
    const ProgramResult result = compare({exr, png, "--json"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.err, HasSubstr("b.png: its white is taken as 1 cd/m^2"));
    EXPECT_LT(number(result.out, "max"), 0.01);
}

// Samples [0, 3) and [3, 9) of the same film; the states say that both have seed 7.
TEST_F(CompareProgram, FilmsTellTheirNoise) {
    const std::string a = folder_.file("a.film.exr"), b = folder_.file("b.exr");
    FilmOptions options = small_film();
    options.variance = FilmVariance::xyz;
    write_film_state(a, film_state(options, 0, 3));
    const FilmState other = film_state(options, 3, 9);
    const Film film(other.options, other.contents);
    FilmMetadata metadata = other.metadata;
    metadata.seed = 8;
    (void)write_exr(b, picture_of(film), metadata, {.white_luminance_cdm2 = 2.0});
    const ProgramResult result = compare({a, b});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, AllOf(HasSubstr(" % of the squared difference in X, Y and Z, relative to what is around\n"),
                                  HasSubstr("due to bias "), Not(HasSubstr("unknown")), Not(HasSubstr("note"))));
    const std::string json = compare({a, b, "--json"}).out;
    EXPECT_NEAR(number(json, "bias_share"), 0.0, 4.0 * number(json, "bias_share_standard_error"));
    EXPECT_LT(number(json, "bias_share_standard_error"), 0.2);

    metadata.seed = 7;
    (void)write_exr(b, picture_of(film), metadata, {.white_luminance_cdm2 = 2.0});
    EXPECT_THAT(compare({a, b}).out, HasSubstr("both have seed 7: if they share samples"));
}

TEST_F(CompareProgram, SecondPicturesTellTheNoiseOfAnySampler) {
    const auto render = [&](const std::string& name, const std::string& seed) {
        const std::string exr = folder_.file(name);
        EXPECT_EQ(run_program({"render", kCornellBox, "-o", exr, "--spp", "4", "--resolution", "64x64", "--seed", seed,
                               "--variance", "xyz", "--quiet"})
                      .exit_code,
                  0);
        return exr;
    };
    const std::string a = render("a.exr", "1"), b = render("b.exr", "2"), a2 = render("a2.exr", "3"),
                      b2 = render("b2.exr", "4");
    // The sampler stratifies: noise is not as much as the film's layers say.
    const std::string by_layers = compare({a, b, "--json"}).out;
    EXPECT_LT(number(by_layers, "bias_share"), -4.0 * number(by_layers, "bias_share_standard_error"));
    EXPECT_THAT(by_layers, HasSubstr("noise is overestimated, bias underestimated"));
    EXPECT_THAT(by_layers, HasSubstr("\"noise_is_upper_bound\": true"));
    const std::string text = compare({a, b}).out;
    EXPECT_THAT(text, HasSubstr("due to noise      at most 100.0 % (estimated "));
    EXPECT_THAT(text, HasSubstr("due to bias       at least 0.0 % (estimated -"));
    const std::string again = compare({a, b, "--a-again", a2, "--b-again", b2, "--json"}).out;
    EXPECT_NEAR(number(again, "bias_share"), 0.0, 4.0 * number(again, "bias_share_standard_error"));
    EXPECT_LT(number(again, "bias_share_standard_error"), 0.1);
    EXPECT_THAT(again, HasSubstr("\"notes\": []"));
    EXPECT_THAT(again, HasSubstr("\"noise_is_upper_bound\": false"));

    const ProgramResult same = compare({a, b, "--a-again", render("c.exr", "1")});
    EXPECT_EQ(same.exit_code, 1);
    EXPECT_THAT(same.err, HasSubstr("both pictures have seed 1: expected independent noise"));
}

class CompareScenes : public CompareProgram {
  protected:
    static std::string compared(const std::string& a, const std::string& b, const std::vector<std::string>& flags) {
        std::vector<std::string> arguments = {a, b, "--json"};
        arguments.insert(arguments.end(), flags.begin(), flags.end());
        const ProgramResult result = compare(arguments);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return result.out;
    }
};

TEST_F(CompareScenes, TheSameModelDiffersByNoiseAlone) {
    const std::string scene = kCornellBox + "@spectral:4";
    const std::string json = compared(scene, scene, {"--spp", "9", "--resolution", "64x64"});
    EXPECT_GT(number(json, "mse"), 0.0);
    EXPECT_NEAR(number(json, "bias_share"), 0.0, 4.0 * number(json, "bias_share_standard_error"));
    EXPECT_LT(number(json, "bias_share_standard_error"), 0.2);
    EXPECT_THAT(json, HasSubstr("\"notes\": []"));
    EXPECT_EQ(json, compared(scene, scene, {"--spp", "9", "--resolution", "64x64", "--threads", "1"}));
    EXPECT_NE(json, compared(scene, scene, {"--spp", "9", "--resolution", "64x64", "--seed", "1"}));
}

TEST_F(CompareScenes, RgbIsBiasedWhereSpectraMatter) {
    const std::string json =
        compared(kCornellBox + "@spectral:8", kCornellBox + "@rgb", {"--spp", "512", "--resolution", "32x32"});
    EXPECT_GT(number(json, "bias_share"), 4.0 * number(json, "bias_share_standard_error"));
}

TEST_F(CompareProgram, WhatDoesNotGoTogetherFails) {
    const std::string a = write_grey("a.exr", 36.0f), other = write_grey("c.exr", 18.0f, 8, 7);
    const auto expect_failure = [](const ProgramResult& result, int exit_code, const std::string& words) {
        EXPECT_EQ(result.exit_code, exit_code) << result.err;
        EXPECT_EQ(result.out, "");
        EXPECT_THAT(result.err, AllOf(StartsWith("emulsion: error: "), HasSubstr(words)));
    };
    expect_failure(compare({a, other}), 1, "A is of a frame of 8x6 pixels, B of one of 8x7: expected the same");
    expect_failure(compare({a, folder_.file("none.exr")}), 1, "none.exr");
    expect_failure(compare({a, kCornellBox + "@pastel"}), 2, "B: ");
    expect_failure(compare({a, kCornellBox + "@rgb", "--b-again", a}), 2, "--b-again: is for pictures in files");
    expect_failure(compare({a, folder_.file("none.pbrt@rgb")}), 1, "none.pbrt: ");
    expect_failure(compare({a}), 2, "B");
    expect_failure(compare({a, other, "--map", a}), 2, "--map");
    expect_failure(compare({a, other, "--map-end", "3"}), 2, "--map-end: needs --map");
    expect_failure(compare({a, other, "--fail-above", "1,x"}), 2, "found \"1,x\", expected MEAN or MEAN,P99");
    expect_failure(compare({a, other, "--white-luminance", "0"}), 2, "found \"0\", expected a number above 0");
    expect_failure(compare({a, other, "--white", "nowhere"}), 2, "--white");
    expect_failure(compare({a, other, "--pipeline", "tonemap=none-such"}), 2, "--pipeline");
    expect_failure(compare({a, other, "--spp", "1"}), 2, "--spp");
}

}  // namespace
}  // namespace emulsion::testing
