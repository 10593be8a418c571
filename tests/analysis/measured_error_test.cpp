// Predictions against what happens: what `render --model auto` chooses for a scene, by the pilot that it takes, is
// compared with many wavelengths on pixels of the whole film, until little noise is left.
//
// Nothing is taken off the measured error for the noise that is in it. How large that is tells the difference of two
// pictures of other seeds; and where it is not small, the test fails, as it has shown nothing.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "analysis/model_analysis.h"
#include "measured_pixels.h"
#include "pathtracer/sample_sequence.h"
#include "pathtracer/scene_parser.h"

namespace emulsion {
namespace {

std::vector<std::string> bundled_scenes() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(EMULSION_SOURCE_DIR "/scenes")) {
        if (entry.path().extension() == ".pbrt") names.push_back(entry.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

PreparedScene bundled(const std::string& name) {
    return {read_scene(EMULSION_SOURCE_DIR "/scenes/" + name + ".pbrt"), 0};
}

bool is_spectral(const ModelPrediction& p) { return std::holds_alternative<SpectralModel>(p.model); }

/// Of the paths that a model has time for while rgb takes the scene's.
int samples_in_equal_time(const PreparedScene& scene, const ModelPrediction& prediction) {
    return std::max(1, static_cast<int>(std::lround(samples_per_pixel(scene.scene().sampler) / prediction.cost)));
}

/// Of how many pixels, and how many paths each.
struct Effort {
    int pixels = 1024;
    int samples = 256;
    double noise_mean = 0.2, noise_p99 = 1.0;  ///< that may be left, CIEDE2000
};

bool within_factor_2_or_small(double predicted, double measured) {
    constexpr double kSmall = 0.2;
    return (predicted <= 2.0 * measured && measured <= 2.0 * predicted) || std::max(predicted, measured) <= kSmall;
}

void expect_as_predicted(const std::string& name, PreparedScene& scene, const ModelAnalysis& analysis,
                         const ModelPrediction& chosen, const Effort& effort) {
    const auto places = test::spread_pixels(scene.scene(), effort.pixels, 99);
    const test::MeasuredError measured =
        test::measured_error(scene, chosen.model, SpectralModel{32, HeroIlluminant{}}, places, effort.samples);
    const std::string found =
        fmt::format("{}: {} predicted {:.2f} / {:.2f}, measured {:.2f} / {:.2f}, of which noise {:.2f} / {:.2f}", name,
                    to_text(chosen.model), chosen.error->mean, chosen.error->p99, measured.mean, measured.p99,
                    measured.noise_mean, measured.noise_p99);
    std::puts(found.c_str());
    EXPECT_LE(measured.noise_mean, effort.noise_mean) << "undecided: " << found;
    EXPECT_LE(measured.noise_p99, effort.noise_p99) << "undecided: " << found;
    EXPECT_LE(measured.mean, analysis.budget.mean) << found;
    EXPECT_LE(measured.p99, analysis.budget.p99) << found;
    EXPECT_TRUE(within_factor_2_or_small(chosen.error->mean, measured.mean)) << found;
    EXPECT_TRUE(within_factor_2_or_small(chosen.error->p99, measured.p99)) << found;
}

/// Root mean square, of one picture in equal time.
void expect_noise_as_predicted(const std::string& name, PreparedScene& scene, const ModelPrediction& prediction,
                               int pixels, double factor) {
    const auto places = test::spread_pixels(scene.scene(), pixels, 99);
    scene.prepare_for(prediction.model);
    const double measured =
        test::measured_noise(scene, prediction.model, places, samples_in_equal_time(scene, prediction));
    const std::string found = fmt::format("{}: {} noise predicted {:.2f}, measured {:.2f}", name,
                                          to_text(prediction.model), prediction.noise, measured);
    std::puts(found.c_str());
    EXPECT_LE(measured, factor * prediction.noise) << found;
    EXPECT_LE(prediction.noise, factor * measured) << found;
}

class MeasuredError : public ::testing::TestWithParam<std::string> {};
TEST_P(MeasuredError, IsAsPredicted) {
    PreparedScene scene = bundled(GetParam());
    const ModelAnalysis analysis = analyse_models(scene, {});
    expect_as_predicted(GetParam(), scene, analysis, analysis.models[analysis.chosen], {.samples = 256});
}
std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}
/// Those of little noise.
INSTANTIATE_TEST_SUITE_P(Scenes, MeasuredError, ::testing::Values("colorchecker", "folded-screen", "metamers"),
                         test_name);

/// Where wavelengths meet lines, and where glass leaves one of them.
TEST(MeasuredNoise, IsAsPredictedWhereLightDisperses) {
    for (const std::string name : {"/scenes/still-life", "/tests/data/scenes/sodium-glass"}) {
        PreparedScene scene(read_scene(EMULSION_SOURCE_DIR + name + ".pbrt"), 0);
        const ModelAnalysis analysis = analyse_models(scene, {});
        const ModelPrediction chosen = analysis.models[analysis.chosen];
        EXPECT_TRUE(is_spectral(chosen));
        expect_noise_as_predicted(name, scene, chosen, 512, 1.8);
    }
}

constexpr int kSeeds = 5;

class LongMeasuredError : public ::testing::TestWithParam<std::string> {};
/// Whatever the pilot's seed: models next to each other at the most, and every one of them within the budget.
TEST_P(LongMeasuredError, IsAsPredicted) {
    PreparedScene scene = bundled(GetParam());
    ModelAnalysis analysis;
    std::set<std::size_t> chosen;
    for (int seed = kSeeds - 1; seed >= 0; --seed) {  // the program's last: its predictions are those compared
        analysis = analyse_models(scene, {}, {.seed = static_cast<std::uint64_t>(seed)});
        chosen.insert(analysis.chosen);
    }
    const ModelPrediction& usual = analysis.models[analysis.chosen];
    for (const std::size_t i : chosen) std::puts(fmt::format("chosen: {}", to_text(analysis.models[i].model)).c_str());
    // The pilot takes paths for independent: better spread ones have down to half that noise. And rare bright paths, as
    // the prism has, are too few in it.
    expect_noise_as_predicted(GetParam(), scene, usual, 1024, GetParam() == "prism" ? 5.0 : 2.5);
    if (is_spectral(usual)) {
        for (const std::size_t i : chosen) EXPECT_TRUE(is_spectral(analysis.models[i]));
        return;  // no error but noise: that of spectral models is compared in tests/pathtracer
    }
    EXPECT_LE(*chosen.rbegin() - *chosen.begin(), 1u);
    for (const std::size_t i : chosen) {
        const int samples = GetParam() == "sunlit-room" ? 16384 : 4096;  // its light comes through a window
        expect_as_predicted(GetParam(), scene, analysis, analysis.models[i], {.samples = samples});
    }
}
INSTANTIATE_TEST_SUITE_P(Long, LongMeasuredError, ::testing::ValuesIn(bundled_scenes()), test_name);

}  // namespace
}  // namespace emulsion
