#include "analysis/model_analysis.h"

#include <cmath>
#include <cstddef>
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
using ::testing::MatchesRegex;
using ::testing::Not;

/// A pilot for what doesn't depend on its size.
constexpr PilotOptions kSmall = {.pixels = 512, .samples_per_pixel = 32, .threads = 1};

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
    const ModelAnalysis analysis = analyse_models(scene, {}, kSmall);
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

/// Whatever the budget. Models of channels have one index of refraction: nothing is predicted of them.
TEST(ModelAnalysis, DispersionTakesWavelengths) {
    PreparedScene scene = bundled("prism");
    const ModelAnalysis analysis = analyse_models(scene, {100.0, 100.0}, kSmall);
    EXPECT_TRUE(analysis.disperses);
    EXPECT_GT(analysis.dispersed_share, 0.1);
    EXPECT_TRUE(std::holds_alternative<SpectralModel>(analysis.models[analysis.chosen].model));
    EXPECT_THAT(reasons(analysis), HasSubstr("% of the light, which models of channels don't see\nnoise dE00 "));
    EXPECT_THAT(reasons(analysis), Not(HasSubstr("rgb")));
    EXPECT_TRUE(scene.is_prepared_for(analysis.models[analysis.chosen].model));
    for (const ModelPrediction& p : analysis.models) {
        EXPECT_EQ(p.error.has_value(), std::holds_alternative<SpectralModel>(p.model)) << to_text(p.model);
        EXPECT_EQ(p.good_enough, p.error.has_value()) << to_text(p.model);
    }
}

/// A room under lines of 1 nm, with a ball of dispersing glass in it, or without. At equal samples, fewer wavelengths
/// are never better; and among the strategies that know the lines is the best.
TEST(ModelAnalysis, LinesTakeAStrategyThatKnowsThem) {
    PreparedScene scene(read_scene(EMULSION_SOURCE_DIR "/tests/data/scenes/sodium-glass.pbrt"), 1);
    const ModelAnalysis analysis = analyse_models(scene, {}, kSmall);
    const auto* chosen = std::get_if<SpectralModel>(&analysis.models[analysis.chosen].model);
    ASSERT_NE(chosen, nullptr);
    EXPECT_TRUE(std::holds_alternative<HeroIlluminant>(chosen->strategy)) << to_text(*chosen);
    for (const ModelPrediction& p : analysis.models) {
        const auto* blind = std::get_if<SpectralModel>(&p.model);
        if (blind == nullptr || !std::holds_alternative<HeroVisible>(blind->strategy)) continue;
        EXPECT_GT(p.noise, 2.0 * analysis.models[analysis.chosen].noise) << to_text(p.model);
    }
}

/// Cells of a checkerboard as small as four pixels, in a light of lines: the pilot's pixels must not be means of both
/// colours. Measured: 5.45 in the mean.
TEST(ModelAnalysis, FineTexturesAreSeenPixelByPixel) {
    PreparedScene scene(read_scene(EMULSION_SOURCE_DIR "/tests/data/scenes/fine-texture.pbrt"), 1);
    const ModelAnalysis analysis = analyse_models(scene, {}, {.samples_per_pixel = 4, .threads = 1});
    ASSERT_EQ(to_text(analysis.models[0].model), "rgb:sRGB");
    EXPECT_NEAR(analysis.models[0].error->mean, 5.45, 0.1);
    EXPECT_NE(analysis.chosen, 0u);
}

/// Parts of a picture are rendered by one model.
TEST(ModelAnalysis, IsTheSameForAllCrops) {
    Scene whole = read_scene(EMULSION_SOURCE_DIR "/scenes/folded-screen.pbrt"), left = whole;
    left.film.pixel_bounds = PixelBounds{0, 0, 40, 320};
    PreparedScene whole_scene(std::move(whole), 1), left_scene(std::move(left), 1);
    EXPECT_EQ(reasons(analyse_models(whole_scene, {}, kSmall)), reasons(analyse_models(left_scene, {}, kSmall)));
}

TEST(ModelAnalysis, ReasonsAreTwoLinesOfFixedNumbers) {
    PreparedScene scene = bundled("folded-screen");
    EXPECT_THAT(reasons(analyse_models(scene, {}, kSmall)),
                MatchesRegex("rgb-prefiltered: predicted dE00 [0-9.]+ mean, [0-9.]+ p99; asked for 1 mean, 3 p99\n"
                             "rgb:sRGB [0-9.]+ mean, [0-9.]+ p99; spectral:4 would cost 1.[0-9]+x"));
}

TEST(ModelAnalysis, TheBudgetDecides) {
    PreparedScene scene = bundled("cornell-box");
    std::size_t last_chosen = 0;
    for (const double mean : {10.0, 1.0, 0.1, 0.0}) {
        const ModelAnalysis analysis = analyse_models(scene, {mean, 3.0 * mean}, kSmall);
        const ModelPrediction& chosen = analysis.models[analysis.chosen];
        EXPECT_TRUE(chosen.good_enough);
        EXPECT_LE(chosen.error->mean, mean);
        EXPECT_GE(analysis.chosen, last_chosen) << mean;
        // Nothing but wavelengths is without error.
        EXPECT_TRUE(mean > 0.0 || std::holds_alternative<SpectralModel>(chosen.model)) << to_text(chosen.model);
        last_chosen = analysis.chosen;
    }
}

TEST(ModelAnalysis, IsTheSameForAllNumbersOfThreads) {
    PreparedScene scene = bundled("colorchecker");
    PilotOptions two_threads = kSmall;
    two_threads.threads = 2;
    const ModelAnalysis one = analyse_models(scene, {}, kSmall), two = analyse_models(scene, {}, two_threads);
    ASSERT_EQ(one.models.size(), two.models.size());
    for (std::size_t i = 0; i < one.models.size(); ++i) {
        ASSERT_TRUE(one.models[i].error && two.models[i].error);
        EXPECT_EQ(one.models[i].error->mean, two.models[i].error->mean);
        EXPECT_EQ(one.models[i].error->p99, two.models[i].error->p99);
        EXPECT_EQ(one.models[i].noise, two.models[i].noise);
    }
    EXPECT_EQ(reasons(one), reasons(two));
}

/// Knowing the light is worth most where it has bands.
TEST(ModelAnalysis, NoiseTellsTheStrategies) {
    const auto noise = [](const std::string& name, const TransportModel& model) {
        PreparedScene scene = bundled(name);
        const ModelAnalysis analysis = analyse_models(scene, {}, kSmall);
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
    const ModelAnalysis analysis = analyse_models(scene, {}, kSmall);
    EXPECT_TRUE(std::holds_alternative<SpectralModel>(analysis.models[analysis.chosen].model));
    EXPECT_THAT(reasons(analysis), HasSubstr("of observer cie_1964_10deg"));
}

TEST(ModelAnalysis, ScenesWithoutLightAreBlackInEveryModel) {
    Scene dark = two_walls(ConstantSpectrum{0.5}, ConstantSpectrum{1.0});
    dark.lights.clear();
    PreparedScene scene(dark, 1);
    const ModelAnalysis analysis = analyse_models(scene, {}, kSmall);
    EXPECT_EQ(to_text(analysis.models[analysis.chosen].model), "rgb:sRGB");
    EXPECT_EQ(analysis.models[analysis.chosen].error->mean, 0.0);
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
