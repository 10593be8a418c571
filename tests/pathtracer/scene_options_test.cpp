#include "pathtracer/scene_options.h"

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pathtracer/render.h"
#include "scene_text.h"

namespace emulsion {
namespace {

using testing::error_of;

Scene parse_options(const std::string& options) { return testing::parse(options + "\nWorldBegin\n"); }

const PerspectiveCamera& perspective(const Scene& scene) { return std::get<PerspectiveCamera>(scene.camera); }

TEST(SceneOptions, Defaults) {
    const Scene scene = parse_options("");
    EXPECT_EQ(perspective(scene).world_from_camera, Imath::M44d());
    EXPECT_EQ(perspective(scene).fov_deg, 90.0);
    EXPECT_FALSE(perspective(scene).screen.bounds);
    EXPECT_FALSE(perspective(scene).screen.frame_aspect_ratio);
    EXPECT_EQ(scene.film.width_px, 1280);
    EXPECT_EQ(scene.film.height_px, 720);
    EXPECT_EQ(scene.film.filename, "");
    EXPECT_EQ(scene.film.sensor, SensorOptions{});
    EXPECT_EQ(scene.film.pixel_type, PixelType::float32);
    EXPECT_EQ(scene.filter, Filter(GaussianFilter{}));
    EXPECT_EQ(std::get<PaddedSobolSampler>(scene.sampler).samples_per_pixel, 16);
    EXPECT_EQ(scene.sampler_seed, 0);
    EXPECT_EQ(scene.integrator.max_depth, 5);
}

TEST(SceneOptions, Camera) {
    const Scene scene = parse_options(R"(Camera "perspective" "float fov" 39.5 "float frameaspectratio" [ 1.5 ]
        "float screenwindow" [ -1 2 -3 4 ] "float lensradius" 0.25 "float focaldistance" 12)");
    EXPECT_EQ(perspective(scene).fov_deg, 39.5);
    EXPECT_EQ(perspective(scene).screen.frame_aspect_ratio, 1.5);
    EXPECT_EQ(perspective(scene).screen.bounds, (std::array<double, 4>{-1, 2, -3, 4}));
    EXPECT_EQ(perspective(scene).lens.radius, 0.25);
    EXPECT_EQ(perspective(scene).lens.focal_distance, 12.0);

    const Scene parallel = parse_options(R"(Translate 0 0 -3 Camera "orthographic" "float lensradius" 2
        "float screenwindow" [ -1 2 -3 4 ] "float frameaspectratio" 2)");
    const auto& orthographic = std::get<OrthographicCamera>(parallel.camera);
    EXPECT_EQ(orthographic.world_from_camera.translation() + parallel.origin, Imath::V3d(0, 0, 3));
    EXPECT_EQ(orthographic.screen.bounds, (std::array<double, 4>{-1, 2, -3, 4}));
    EXPECT_EQ(orthographic.screen.frame_aspect_ratio, 2.0);
    EXPECT_EQ(orthographic.lens.radius, 2.0);
    EXPECT_EQ(orthographic.lens.focal_distance, 1e6);

    const auto mapping = [](const std::string& parameters) {
        return std::get<SphericalCamera>(parse_options("Camera \"spherical\" " + parameters).camera).mapping;
    };
    EXPECT_EQ(mapping(""), SphericalMapping::equal_area);
    EXPECT_EQ(mapping(R"("string mapping" "equalarea" "float lensradius" 1)"), SphericalMapping::equal_area);
    EXPECT_EQ(mapping(R"("string mapping" "equirectangular")"), SphericalMapping::equirectangular);
}

TEST(SceneOptions, CropWindowsInPartsOfTheFrameAndInPixels) {
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

TEST(SceneOptions, CropsAreCutOffAtTheFrameAsInPbrt) {
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

TEST(SceneOptions, AShutterThatClosesFirstIsTakenTheOtherWayRoundAsInPbrt) {
    const Scene scene = parse_options(R"(Camera "perspective" "float shutteropen" 2 "float shutterclose" 1.75)");
    EXPECT_EQ(scene.film.sensor.exposure_time_s, 0.25);
    EXPECT_THAT(scene.warnings,
                ::testing::Contains("t.pbrt:1:8: the shutter closes before it opens: taken the other way "
                                    "round"));
}

TEST(SceneOptions, AFilmOfGeometryIsTakenForItsPicture) {
    const Scene scene = parse_options(R"(Film "gbuffer" "integer xresolution" 64 "string coordinatesystem" "world")");
    EXPECT_EQ(scene.film.width_px, 64);
    EXPECT_THAT(scene.warnings,
                ::testing::Contains("t.pbrt:1:6: film \"gbuffer\" is taken as \"rgb\": the same picture "
                                    "without layers of its own"));
}

TEST(SceneOptions, Film) {
    const Scene scene = parse_options(R"(Film "rgb" "integer xresolution" 640 "integer yresolution" [480]
        "string filename" "out.exr" "bool savefp16" true "string sensor" "cie1931" "float diagonal" 50)");
    EXPECT_EQ(scene.film.width_px, 640);
    EXPECT_EQ(scene.film.height_px, 480);
    EXPECT_EQ(scene.film.filename, "out.exr");
    EXPECT_EQ(scene.film.pixel_type, PixelType::half);
}

TEST(SceneOptions, ImagingRatioIsExposureTimesIso) {
    const std::string camera = R"(Camera "perspective" "float shutteropen" 0.25 "float shutterclose" 0.75 )";
    const std::string film = R"(Film "rgb" "float iso" 400 )";
    EXPECT_DOUBLE_EQ(imaging_ratio(parse_options(camera + film).film.sensor), 2.0);
    EXPECT_DOUBLE_EQ(imaging_ratio(parse_options(film + camera).film.sensor), 2.0);
    EXPECT_DOUBLE_EQ(imaging_ratio(parse_options(film).film.sensor), 4.0);
}

// pbrt-v4's temperatures are nominal: its 6500 is D65, of 6503.6 K by today's radiation constant.
TEST(SceneOptions, WhiteBalance) {
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

// The camera's time also reaches a film that is described before it or not at all.
TEST(SceneOptions, ExposureTimeIsTheCameras) {
    const std::string camera = R"(Camera "perspective" "float shutterclose" 0.125 )";
    EXPECT_EQ(parse_options(camera).film.sensor, SensorOptions{.exposure_time_s = 0.125});
    EXPECT_EQ(parse_options(R"(Film "rgb" "float iso" 200 )" + camera).film.sensor,
              (SensorOptions{.exposure_time_s = 0.125, .iso = 200.0}));
}

TEST(SceneOptions, Samplers) {
    EXPECT_EQ(std::get<IndependentSampler>(parse_options("Sampler \"independent\"").sampler).samples_per_pixel, 4);
    const Scene independent = parse_options(R"(Sampler "independent" "integer pixelsamples" 7 "integer seed" 3)");
    EXPECT_EQ(std::get<IndependentSampler>(independent.sampler).samples_per_pixel, 7);
    EXPECT_EQ(independent.sampler_seed, 3);

    const Scene sobol = parse_options(R"(Sampler "paddedsobol" "integer pixelsamples" 64
        "string randomization" "owen" "integer seed" -1)");
    EXPECT_EQ(std::get<PaddedSobolSampler>(sobol.sampler).samples_per_pixel, 64);
    EXPECT_EQ(sobol.sampler_seed, -1);

    const Scene stratified = parse_options(R"(Sampler "stratified" "integer xsamples" 3 "integer ysamples" 5
        "bool jitter" false)");
    const auto& strata = std::get<StratifiedSampler>(stratified.sampler);
    EXPECT_EQ(strata.x_samples, 3);
    EXPECT_EQ(strata.y_samples, 5);
    EXPECT_FALSE(strata.jitter);
    EXPECT_TRUE(std::get<StratifiedSampler>(parse_options("Sampler \"stratified\"").sampler).jitter);
}

/// What is warned of, but for the missing light.
std::vector<std::string> warnings_of(const std::string& options) {
    Scene scene = parse_options(options);
    scene.warnings.pop_back();
    return scene.warnings;
}

TEST(SceneOptions, TheClosestSamplerIsTakenAndSaid) {
    const auto warnings = [](const std::string& sampler) { return warnings_of("Sampler " + sampler); };
    for (const std::string name : {"halton", "sobol", "zsobol", "pmj02bn"}) {
        const std::string said =
            "t.pbrt:1:9: sampler \"" + name + "\" is taken as \"paddedsobol\": the same picture with other noise";
        const std::string sampler = '"' + name + R"(" "integer pixelsamples" 100 "integer seed" 3)";
        const Scene scene = parse_options("Sampler " + sampler);
        EXPECT_EQ(std::get<PaddedSobolSampler>(scene.sampler).samples_per_pixel, 100) << name;
        EXPECT_EQ(scene.sampler_seed, 3) << name;
        EXPECT_THAT(warnings(sampler), ::testing::ElementsAre(said));
        if (name == "pmj02bn") continue;
        EXPECT_THAT(warnings(sampler + R"( "string randomization" "permutedigits")"),
                    ::testing::ElementsAre(said + "; of no effect: \"randomization\""));
    }
    EXPECT_THAT(
        warnings(R"("paddedsobol" "string randomization" "none")"),
        ::testing::ElementsAre("t.pbrt:1:9: randomization \"none\" of sampler \"paddedsobol\" is taken as \"owen\""));
    EXPECT_THAT(warnings(R"("paddedsobol" "string randomization" "fastowen")"), ::testing::IsEmpty());
}

TEST(SceneOptions, IntegratorsOfTheSamePictureAreTakenAsPath) {
    const auto said = [](const std::string& name) {
        return "t.pbrt:1:12: integrator \"" + name + "\" is taken as \"path\": the same picture with other noise";
    };
    for (const std::string name : {"volpath", "simplepath", "simplevolpath", "bdpt", "mlt"}) {
        const std::string text = "Integrator \"" + name + R"(" "integer maxdepth" 7)";
        EXPECT_EQ(parse_options(text).integrator.max_depth, 7) << name;
        EXPECT_THAT(warnings_of(text), ::testing::ElementsAre(said(name)));
    }
    EXPECT_THAT(warnings_of(R"(Integrator "mlt" "integer chains" 100 "float sigma" .02)"),
                ::testing::ElementsAre(said("mlt") + "; of no effect: \"chains\", \"sigma\""));
    EXPECT_THAT(warnings_of(R"(Integrator "path" "string lightsampler" "bvh")"), ::testing::IsEmpty());
}

TEST(SceneOptions, AcceleratorsAreOfNoEffect) {
    EXPECT_THAT(warnings_of(R"(Accelerator "kdtree" "integer maxprims" 4 "float emptybonus" .5)"),
                ::testing::IsEmpty());
    EXPECT_THAT(warnings_of(R"(Accelerator "bvh" "string splitmethod" "hlbvh" "integer maxnodeprims" 4)"),
                ::testing::IsEmpty());
}

TEST(SceneOptions, SpectralFilm) {
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

TEST(SceneOptions, FiltersHaveTheParametersOfPbrt) {
    const std::string radii = R"( "float xradius" 1.25 "float yradius" 3)";
    EXPECT_EQ(parse_options("PixelFilter \"box\"" + radii).filter, Filter(BoxFilter{1.25f, 3.0f}));
    EXPECT_EQ(parse_options("PixelFilter \"triangle\"" + radii).filter, Filter(TriangleFilter{1.25f, 3.0f}));
    EXPECT_EQ(parse_options("PixelFilter \"gaussian\" \"float sigma\" .7" + radii).filter,
              Filter(GaussianFilter{1.25f, 3.0f, 0.7f}));
    EXPECT_EQ(parse_options("PixelFilter \"mitchell\" \"float B\" 0 \"float C\" .5" + radii).filter,
              Filter(MitchellFilter{1.25f, 3.0f, 0.0f, 0.5f}));
    EXPECT_EQ(parse_options("PixelFilter \"sinc\" \"float tau\" 2" + radii).filter,
              Filter(LanczosSincFilter{1.25f, 3.0f, 2.0f}));
    EXPECT_EQ(parse_options("PixelFilter \"mitchell\"").filter, Filter(MitchellFilter{}));
}

TEST(SceneOptions, TakesEveryFilterByItsNameAndWithItsDefaults) {
    for_each_alternative<Filter>([]<class F>(const F& filter) {
        const std::string directive = "PixelFilter \"" + std::string(F::kName) + '"';
        EXPECT_EQ(parse_options(directive).filter, Filter(filter));
        F wide = filter;
        wide.x_radius_px = 5.5f;
        EXPECT_EQ(parse_options(directive + R"( "float xradius" 5.5)").filter, Filter(wide));
    });
}

TEST(SceneOptions, Integrator) {
    const Scene scene = parse_options(R"(Integrator "path" "integer maxdepth" 0 "string lightsampler" "bvh"
        "bool regularize" false)");
    EXPECT_EQ(scene.integrator.max_depth, 0);
    for (const std::string sampler : {"uniform", "power", "exhaustive"}) {
        EXPECT_NO_THROW(parse_options("Integrator \"path\" \"string lightsampler\" \"" + sampler + "\"")) << sampler;
    }
}

TEST(SceneOptions, NumbersMayBeDeclaredEitherWay) {
    EXPECT_EQ(perspective(parse_options(R"(Camera "perspective" "integer fov" 45)")).fov_deg, 45.0);
    EXPECT_EQ(parse_options(R"(Film "rgb" "float xresolution" 300.0)").film.width_px, 300);
    EXPECT_EQ(parse_options(R"(Film "rgb" "integer xresolution" 3e2)").film.width_px, 300);
    EXPECT_EQ(
        error_of(R"(Film "rgb" "float xresolution" 300.5)"),
        "t.pbrt:1:32: found 300.5 for parameter \"xresolution\" of film \"rgb\", expected a whole number of at most "
        "32 bits");
    EXPECT_EQ(error_of(R"(Film "rgb" "integer xresolution" 300.5)"),
              "t.pbrt:1:34: found \"300.5\", expected a whole number of at most 32 bits");
    EXPECT_EQ(error_of(R"(Film "rgb" "integer xresolution" 3000000000)"),
              "t.pbrt:1:34: found \"3000000000\", expected a whole number of at most 32 bits");
}

TEST(SceneOptions, FlagsMayBeQuoted) {
    EXPECT_EQ(parse_options(R"(Film "rgb" "bool savefp16" "true")").film.pixel_type, PixelType::half);
    EXPECT_EQ(parse_options(R"(Film "rgb" "bool savefp16" ["false"])").film.pixel_type, PixelType::float32);
    EXPECT_EQ(error_of(R"(Film "rgb" "bool savefp16" 1)"), "t.pbrt:1:28: found \"1\", expected true or false");
}

TEST(SceneOptions, TheLaterOfTwoIsTakenAndWarnedOf) {
    const Scene scene =
        parse_options("Film \"rgb\" \"integer xresolution\" 100 \"integer yresolution\" 50\n Film \"rgb\"");
    EXPECT_EQ(scene.film.width_px, 1280);
    ASSERT_FALSE(scene.warnings.empty());
    EXPECT_EQ(scene.warnings[0], "t.pbrt:2:2: Film replaces the one at t.pbrt:1:1");
}

TEST(SceneOptions, RefusesFiltersThatCantBeNormalised) {
    // A Gaussian that is flat over the support less its value at the end is 0; lobes of a milliard outweigh their sum.
    for (const std::string filter : {R"("gaussian" "float sigma" 1e30)", R"("mitchell" "float B" 1e9)"}) {
        const std::string message = error_of("PixelFilter " + filter);
        EXPECT_EQ(message.rfind("t.pbrt:1:13: found a pixel filter that can't be normalised (", 0), 0u) << message;
    }
}

struct BadOption {
    std::string text, message;
};

TEST(SceneOptions, RefusesValuesOutOfRange) {
    const BadOption bad[] = {
        {R"(Camera "perspective" "float fov" 180)",
         "1:34: found a field of view of 180, expected an angle above 0 and below 180 degrees"},
        {R"(Camera "perspective" "float fov" [-1])",
         "1:35: found -1 for parameter \"fov\" of camera \"perspective\", expected a number above 0"},
        {R"(Camera "perspective" "float lensradius" -.1)",
         "1:41: found -0.1 for parameter \"lensradius\" of camera \"perspective\", expected 0 or a number above"},
        {R"(Camera "orthographic" "float fov" 40)",
         "1:23: found unknown parameter \"fov\" of camera \"orthographic\", expected a known one (frameaspectratio, "
         "screenwindow, lensradius, focaldistance, shutteropen, shutterclose)"},
        {R"(Camera "spherical" "string mapping" "equalaria")",
         "1:37: found unknown mapping \"equalaria\", expected a known one (nearest known name: \"equalarea\")"},
        {R"(Film "spectral" "integer nbuckets" 1025)",
         "1:6: found buckets of wavelengths that can't be (film: spectrum.count = 1025: must be in [1, 1024]), "
         "expected \"lambdamin\" "
         "below \"lambdamax\", and from 1 to 1024 \"nbuckets\" between them"},
        {R"(Film "spectral" "float lambdamin" 300)",
         "1:6: found wavelengths from 300 to 830 nm, expected some of those that paths have, from 360 to 830 nm"},
        {R"(Film "rgb" "integer nbuckets" 4)",
         "1:12: found unknown parameter \"nbuckets\" of film \"rgb\", expected a known one (xresolution, yresolution, "
         "filename, savefp16, sensor, iso, diagonal, cropwindow, pixelbounds, whitebalance, maxcomponentvalue)"},
        {R"(Camera "perspective" "float screenwindow" [0 1 2])",
         "1:22: found 3 values for parameter \"screenwindow\" of camera \"perspective\", expected 4"},
        {R"(Camera "perspective" "float screenwindow" [1 1 0 1])",
         "1:44: found a screen window without area, expected x min, x max, y min, y max"},
        {R"(Camera "perspective" "float shutteropen" 1)",
         "1:8: found an exposure time of 0, expected \"shutterclose\" after \"shutteropen\""},
        {R"(Film "rgb" "integer xresolution" 0)",
         "1:34: found 0 for parameter \"xresolution\" of film \"rgb\", expected a number above 0"},
        {R"(Film "rgb" "integer xresolution" 65536 "integer yresolution" 65536)",
         "1:6: found 65536 x 65536 pixels, expected at most 2147483647 in all"},
        {R"(Film "rgb" "integer xresolution" 65537)",
         "1:34: found 65537 for parameter \"xresolution\", expected at most 65536"},
        {R"(Film "rgb" "integer yresolution" 65537)",
         "1:34: found 65537 for parameter \"yresolution\", expected at most 65536"},
        {R"(Camera "perspective" "float lensradius" 1e19)",
         "1:8: found a camera that reaches 1e+19 units, each 1 long, expected coordinates from -1e15 to 1e15 in world "
         "space"},
        {R"(Camera "orthographic" "float screenwindow" [-1e19 1e19 -1 1])",
         "1:8: found a camera that reaches 1e+19 units, each 1 long, expected coordinates from -1e15 to 1e15 in world "
         "space"},
        {R"(Scale 1e-20 1e-20 1e-20 Camera "orthographic")",
         "1:32: found a camera that reaches 1 units, each 1e+20 long, expected coordinates from -1e15 to 1e15 in world "
         "space"},
        {R"(Sampler "independent" "integer pixelsamples" 16777217)",
         "1:46: found 16777217 for parameter \"pixelsamples\", expected at most 16777216"},
        {R"(Sampler "paddedsobol" "integer pixelsamples" 16777217)",
         "1:46: found 16777217 for parameter \"pixelsamples\", expected at most 16777216"},
        {R"(Scale 1e-120 1e-120 1e-120 Camera "perspective")",
         "1:35: found a camera under a transformation without inverse, expected another one"},
        {R"(Translate -1.5e15 0 2 Camera "perspective")",
         "1:30: found a camera at (1.5e+15, 0, -2), expected coordinates from -1e15 to 1e15 in world space"},
        {R"(Film "rgb" "float iso" 1e60)",
         "1:6: found an ISO speed of 1e+60, expected a number that single precision holds"},
        {R"(Film "rgb" "float iso" 1e35 WorldBegin)",
         "1:29: found a scene whose exposure time times ISO / 100 is 1e+33, expected from 1e-30 to 1e+30"},
        {R"(Film "rgb" "float whitebalance" [ 900 ])",
         "1:35: found 900 for parameter \"whitebalance\", expected a colour temperature from 1000 to 24986 K, or 0 for "
         "no white balance"},
        {R"(Film "rgb" "float whitebalance" 24987)",
         "1:33: found 24987 for parameter \"whitebalance\", expected a colour temperature from 1000 to 24986 K, or 0 "
         "for no white balance"},
        {R"(Film "rgb" "float whitebalance" -1)",
         "1:33: found -1 for parameter \"whitebalance\" of film \"rgb\", expected 0 or a number above"},
        {R"(Film "rgb" "string sensor" "nikon_d850")",
         "1:28: found sensor \"nikon_d850\", expected a supported one (known to pbrt-v4 and not yet supported here; "
         "supported: cie1931)"},
        {R"(Film "rgb" "string sensor" "cie1932")",
         "1:28: found unknown sensor \"cie1932\", expected a known one (nearest known name: \"cie1931\")"},
        {R"(Sampler "stratified" "integer xsamples" 65536 "integer ysamples" 65536)",
         "1:9: found 65536 x 65536 samples, expected at most 16777216 in all"},
        {R"(Sampler "zsobol" "string randomization" "nun")",
         "1:41: found unknown randomization \"nun\", expected a known one (nearest known name: \"none\")"},
        {R"(Sampler "pmj02bn" "string randomization" "none")",
         "1:19: found unknown parameter \"randomization\" of sampler \"pmj02bn\", expected a known one (nearest known "
         "name: \"seed\")"},
        {R"(Sampler "halton" "integer pixelsamples" 16777217)",
         "1:41: found 16777217 for parameter \"pixelsamples\", expected at most 16777216"},
        {R"(Accelerator "bwh")",
         "1:13: found unknown accelerator \"bwh\", expected a known one (nearest known name: \"bvh\")"},
        {R"(Accelerator "bvh" "string splitmethod" "sha")",
         "1:40: found unknown splitmethod \"sha\", expected a known one (nearest known name: \"sah\")"},
        {R"(PixelFilter "box" "float xradius" 1e-60)",
         "1:35: found 1e-60 for parameter \"xradius\", expected a number that single precision holds"},
        {R"(Integrator "path" "integer maxdepth" -1)",
         "1:38: found -1 for parameter \"maxdepth\" of integrator \"path\", expected 0 or a number above"},
        {R"(Integrator "path" "bool regularize" true)",
         "1:37: found true for parameter \"regularize\" of integrator \"path\", expected false (others are known to "
         "pbrt-v4 "
         "and not yet supported here)"},
    };
    for (const BadOption& option : bad) EXPECT_EQ(error_of(option.text), "t.pbrt:" + option.message) << option.text;
}

}  // namespace
}  // namespace emulsion
