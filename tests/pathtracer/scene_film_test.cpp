// The Film directive.

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pathtracer/render.h"
#include "pathtracer/scene_options.h"
#include "scene_text.h"

namespace emulsion {
namespace {

using testing::error_of;
using testing::parse_options;

TEST(SceneFilm, Film) {
    const Scene scene = parse_options(R"(Film "rgb" "integer xresolution" 640 "integer yresolution" [480]
        "string filename" "out.exr" "bool savefp16" true "string sensor" "cie1931" "float diagonal" 50)");
    EXPECT_EQ(scene.film.width_px, 640);
    EXPECT_EQ(scene.film.height_px, 480);
    EXPECT_EQ(scene.film.filename, "out.exr");
    EXPECT_EQ(scene.film.pixel_type, PixelType::half);
}

TEST(SceneFilm, SpectralFilm) {
    EXPECT_EQ(film_options(parse_options("Film \"rgb\"")).spectrum, std::nullopt);
    EXPECT_EQ(film_options(parse_options("Film \"spectral\"")).spectrum, (SpectralBuckets{16, 360.0, 830.0}));
    const Scene scene = parse_options(R"(Film "spectral" "integer nbuckets" 8 "float lambdamin" 400
        "float lambdamax" 700 "integer xresolution" 20 "integer yresolution" 10 "float iso" 200
        "string filename" "s.exr" "bool savefp16" true)");
    EXPECT_EQ(film_options(scene).spectrum, (SpectralBuckets{8, 400.0, 700.0}));
    EXPECT_EQ(scene.film.width_px, 20);
    EXPECT_EQ(scene.film.sensor.iso, 200.0);
    EXPECT_EQ(scene.film.pixel_type, PixelType::half);
}

TEST(SceneFilm, AFilmOfGeometryIsTakenForItsPicture) {
    const Scene scene = parse_options(R"(Film "gbuffer" "integer xresolution" 64 "string coordinatesystem" "world")");
    EXPECT_EQ(scene.film.width_px, 64);
    EXPECT_THAT(scene.warnings,
                ::testing::Contains("t.pbrt:1:6: film \"gbuffer\" is taken as \"rgb\": the same picture "
                                    "without layers of its own"));
}

TEST(SceneFilm, CropWindowsInPartsOfTheFrameAndInPixels) {
    const std::string film = R"(Film "rgb" "integer xresolution" 100 "integer yresolution" 50 )";
    EXPECT_EQ(film_options(parse_options(film)).crop, std::nullopt);
    // Rounded up, as pbrt-v4 does: 33.3 to 34, 66.6 to 67, 12.5 to 13.
    EXPECT_EQ(film_options(parse_options(film + R"("float cropwindow" [0.333 0.666 0.25 1])")).crop,
              (PixelBounds{34, 13, 67, 50}));
    Scene scene = parse_options(film + R"("float cropwindow" [0.5 1 0 0.5])");
    scene.film.width_px = 10;  // another resolution, the same part of it
    EXPECT_EQ(film_options(scene).crop, (PixelBounds{5, 0, 10, 25}));
    EXPECT_EQ(film_options(parse_options(film + R"("integer pixelbounds" [10 20 30 50])")).crop,
              (PixelBounds{10, 30, 20, 50}));

    EXPECT_EQ(
        error_of(film + R"("float cropwindow" [0.5 0.5 0 1])"),
        "t.pbrt:1:83: found a cropwindow of 0.5 0.5 0 1, expected x0 < x1 and y0 < y1, in this order, from 0 to 1 and "
        "to 1");
    EXPECT_EQ(error_of(film + R"("integer pixelbounds" [100 200 0 1])"),
              "t.pbrt:1:86: found a pixelbounds of 100 200 0 1, expected x0 < x1 and y0 < y1, in this order, from 0 to "
              "100 and to 50");
}

TEST(SceneFilm, CropsAreCutOffAtTheFrameAsInPbrt) {
    const std::string film = "Film \"rgb\" \"integer xresolution\" 100 \"integer yresolution\" 50 ";
    const auto expect = [&](const std::string& crop, const PixelBounds& bounds, const std::string& warning) {
        const Scene scene = parse_options(film + crop);
        EXPECT_EQ(film_options(scene).crop, bounds) << crop;
        EXPECT_THAT(scene.warnings, ::testing::Contains(::testing::HasSubstr(warning))) << crop;
    };
    expect(R"("float cropwindow" [0.5 1.5 1 -1])", {50, 0, 100, 50},
           R"("cropwindow" [ 0.5 1.5 1 -1 ] is taken as 0.5 1 0 1)");
    expect(R"("integer pixelbounds" [20 10 -5 101])", {10, 0, 20, 50},
           R"("pixelbounds" [ 20 10 -5 101 ] is taken as 10 20 0 50)");
    expect(R"("integer pixelbounds" [0 1 0 1] "float cropwindow" [0 .5 0 1])", {0, 0, 50, 50},
           R"("pixelbounds" have no effect beside "cropwindow")");
}

TEST(SceneFilm, ImagingRatioIsExposureTimesIso) {
    const std::string camera = R"(Camera "perspective" "float shutteropen" 0.25 "float shutterclose" 0.75 )";
    const std::string film = R"(Film "rgb" "float iso" 400 )";
    EXPECT_DOUBLE_EQ(imaging_ratio(parse_options(camera + film).film.sensor), 2.0);
    EXPECT_DOUBLE_EQ(imaging_ratio(parse_options(film + camera).film.sensor), 2.0);
    EXPECT_DOUBLE_EQ(imaging_ratio(parse_options(film).film.sensor), 4.0);
}

// pbrt-v4's temperatures are nominal: its 6500 is D65, of 6503.6 K by today's radiation constant.
TEST(SceneFilm, WhiteBalance) {
    const auto balance = [](const std::string& number) {
        return parse_options(R"(Film "rgb" "float whitebalance" )" + number).film.sensor.white_balance;
    };
    EXPECT_FALSE(balance("0"));
    for (const auto& [text, nominal_K] : {std::pair("6500", 6500.0), std::pair("[ 3200 ]", 3200.0)}) {
        ASSERT_TRUE(balance(text));
        EXPECT_NEAR(std::get<TemperatureWhite>(balance(text)->white).temperature_K, nominal_K * 1.4388 / 1.4380, 1e-9);
        EXPECT_EQ(balance(text)->method, ChromaticAdaptation(BradfordAdaptation{}));
    }
    EXPECT_TRUE(balance("1000"));
    EXPECT_TRUE(balance("24986"));
}

}  // namespace
}  // namespace emulsion
