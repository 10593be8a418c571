#include "pathtracer/scene_options.h"

#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene_text.h"

namespace emulsion {
namespace {

using testing::parse_options;
using testing::perspective;

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

TEST(SceneOptions, Integrator) {
    const Scene scene = parse_options(R"(Integrator "path" "integer maxdepth" 0 "string lightsampler" "bvh"
        "bool regularize" false)");
    EXPECT_EQ(scene.integrator.max_depth, 0);
    for (const std::string sampler : {"uniform", "power", "exhaustive"}) {
        EXPECT_NO_THROW(parse_options("Integrator \"path\" \"string lightsampler\" \"" + sampler + "\"")) << sampler;
    }
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

TEST(SceneOptions, TheLaterOfTwoIsTakenAndWarnedOf) {
    const Scene scene =
        parse_options("Film \"rgb\" \"integer xresolution\" 100 \"integer yresolution\" 50\n Film \"rgb\"");
    EXPECT_EQ(scene.film.width_px, 1280);
    ASSERT_FALSE(scene.warnings.empty());
    EXPECT_EQ(scene.warnings[0], "t.pbrt:2:2: Film replaces the one at t.pbrt:1:1");
}

}  // namespace
}  // namespace emulsion
