#include "analysis/model_analysis.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pathtracer/scene_parser.h"
#include "spectrum/catalogue.h"

namespace emulsion {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

PreparedScene bundled(const std::string& name) {
    return {read_scene(EMULSION_SOURCE_DIR "/scenes/" + name + ".pbrt"), 1};
}

/// Two walls that face each other, the second turned by 90 degrees, under an even sky.
Scene two_walls(const Spectrum& paint, const Spectrum& sky) {
    Scene scene;
    const auto wall = [](const Imath::V3f& corner, const Imath::V3f& edge1, const Imath::V3f& edge2) {
        TriangleMesh mesh;
        mesh.position = {corner, corner + edge1, corner + edge1 + edge2, corner + edge2};
        mesh.triangle = {{0, 1, 2}, {0, 2, 3}};
        return mesh;
    };
    scene.materials = {DiffuseMaterial{paint}};
    scene.shapes = {{wall({-4, -4, 4}, {8, 0, 0}, {0, 8, 0}), 0, {}},
                    {wall({-4, -4, -4}, {8, 0, 0}, {0, 0, 8}), 0, {}}};
    scene.lights = {UniformInfiniteLight{{sky, 0.01}}};
    return scene;
}

std::string chosen_for(const Spectrum& paint, const Spectrum& sky) {
    PreparedScene scene(two_walls(paint, sky), 1);
    const ModelAnalysis analysis = analyse_models(scene, {}, {.threads = 1});
    return to_text(analysis.models[analysis.chosen].model);
}

TEST(ModelAnalysis, GreyAndBroadBandScenesFallToRgb) {
    EXPECT_EQ(chosen_for(ConstantSpectrum{0.7}, catalogue_spectrum("D65")), "rgb:sRGB");
    EXPECT_EQ(chosen_for(ConstantSpectrum{0.7}, catalogue_spectrum("FL11")), "rgb:sRGB");
    EXPECT_EQ(chosen_for(catalogue_spectrum("colorchecker-light-skin"), catalogue_spectrum("D65")), "rgb:sRGB");
}

TEST(ModelAnalysis, SaturatedInterreflectionAndLinesTakeMore) {
    EXPECT_NE(chosen_for(catalogue_spectrum("colorchecker-red"), catalogue_spectrum("FL11")), "rgb:sRGB");
    EXPECT_NE(chosen_for(catalogue_spectrum("colorchecker-purplish-blue"), catalogue_spectrum("HP1")), "rgb:sRGB");
}

TEST(ModelAnalysis, DispersionTakesWavelengths) {
    PreparedScene scene = bundled("prism");
    const ModelAnalysis analysis = analyse_models(scene, {100.0, 100.0}, {.threads = 1});
    EXPECT_TRUE(analysis.disperses);
    EXPECT_GT(analysis.dispersed_share, 0.1);
    EXPECT_TRUE(std::holds_alternative<SpectralModel>(analysis.models[analysis.chosen].model));
    EXPECT_THAT(reasons(analysis), HasSubstr("disperses"));
    EXPECT_TRUE(scene.is_prepared_for(analysis.models[analysis.chosen].model));
}

TEST(ModelAnalysis, BundledScenesTakeWhatTheyNeed) {
    const auto chosen = [](const std::string& name) {
        PreparedScene scene = bundled(name);
        const ModelAnalysis analysis = analyse_models(scene, {}, {.threads = 1});
        return to_text(analysis.models[analysis.chosen].model);
    };
    EXPECT_EQ(chosen("studio"), "rgb:sRGB");
    EXPECT_NE(chosen("folded-screen"), "rgb:sRGB");  // saturated, under FL11
    EXPECT_NE(chosen("colorchecker"), "rgb:sRGB");   // three lights
    EXPECT_THAT(chosen("metamers"), StartsWith("basis:"));
    EXPECT_THAT(chosen("still-life"), StartsWith("spectral:"));  // its glass disperses
}

TEST(ModelAnalysis, TheBudgetDecides) {
    PreparedScene scene = bundled("cornell-box");
    double last_cost = 1.0;
    for (const double mean : {10.0, 1.0, 0.1, 0.0}) {
        const ModelAnalysis analysis = analyse_models(scene, {mean, 3.0 * mean}, {.threads = 1});
        const ModelPrediction& chosen = analysis.models[analysis.chosen];
        EXPECT_TRUE(chosen.good_enough);
        EXPECT_LE(chosen.mean, mean);
        EXPECT_GE(chosen.cost, last_cost) << mean;
        last_cost = chosen.cost;
    }
    EXPECT_GT(last_cost, 1.1);  // nothing but wavelengths is without error
}

TEST(ModelAnalysis, IsTheSameForAllNumbersOfThreads) {
    PreparedScene scene = bundled("colorchecker");
    const ModelAnalysis one = analyse_models(scene, {}, {.threads = 1}),
                        two = analyse_models(scene, {}, {.threads = 2});
    ASSERT_EQ(one.models.size(), two.models.size());
    for (std::size_t i = 0; i < one.models.size(); ++i) {
        EXPECT_EQ(one.models[i].mean, two.models[i].mean);
        EXPECT_EQ(one.models[i].p99, two.models[i].p99);
        EXPECT_EQ(one.models[i].noise, two.models[i].noise);
    }
    EXPECT_EQ(reasons(one), reasons(two));
}

/// Knowing the light is worth most where it has bands.
TEST(ModelAnalysis, NoiseTellsTheStrategies) {
    const auto noise = [](const std::string& name, const TransportModel& model) {
        PreparedScene scene = bundled(name);
        const ModelAnalysis analysis = analyse_models(scene, {}, {.threads = 1});
        for (const ModelPrediction& p : analysis.models) {
            if (p.model == model) return p.noise;
        }
        ADD_FAILURE() << to_text(model);
        return 0.0;
    };
    EXPECT_LT(noise("folded-screen", SpectralModel{4, HeroIlluminant{}}),
              0.6 * noise("folded-screen", SpectralModel{4}));
    EXPECT_GT(noise("cornell-box", SpectralModel{1}), 2.0 * noise("cornell-box", SpectralModel{4}));
}

TEST(ModelAnalysis, FilmsOfOtherEyesTakeWavelengths) {
    Scene film = two_walls(ConstantSpectrum{0.5}, ConstantSpectrum{1.0});
    film.film.sensor.observer = "cie_1964_10deg";
    PreparedScene scene(film, 1);
    const ModelAnalysis analysis = analyse_models(scene, {}, {.threads = 1});
    EXPECT_TRUE(std::holds_alternative<SpectralModel>(analysis.models[analysis.chosen].model));
    EXPECT_THAT(reasons(analysis), HasSubstr("of observer cie_1964_10deg"));
}

TEST(ModelAnalysis, ScenesWithoutLightAreBlackInEveryModel) {
    Scene dark = two_walls(ConstantSpectrum{0.5}, ConstantSpectrum{1.0});
    dark.lights.clear();
    PreparedScene scene(dark, 1);
    const ModelAnalysis analysis = analyse_models(scene, {}, {.threads = 1});
    EXPECT_EQ(to_text(analysis.models[analysis.chosen].model), "rgb:sRGB");
    EXPECT_EQ(analysis.models[analysis.chosen].mean, 0.0);
}

TEST(ModelAnalysis, RefusesBudgetsAndPilotsOutOfRange) {
    PreparedScene scene(two_walls(ConstantSpectrum{0.5}, ConstantSpectrum{1.0}), 1);
    EXPECT_THROW(static_cast<void>(analyse_models(scene, {-1.0, 3.0})), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(analyse_models(scene, {1.0, std::nan("")})), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(analyse_models(scene, {}, {.pixels = 0})), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(analyse_models(scene, {}, {.samples_per_pixel = 0})), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(analyse_models(scene, {}, {.threads = -1})), std::invalid_argument);
}

}  // namespace
}  // namespace emulsion
