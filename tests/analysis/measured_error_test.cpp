// Predictions against what happens: every bundled scene is rendered by the model that was chosen for it and by many
// wavelengths, until little noise is left.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "analysis/model_analysis.h"
#include "film/film.h"
#include "pathtracer/render.h"
#include "pathtracer/scene_parser.h"
#include "spectrum/ciede2000_difference.h"
#include "spectrum/observer.h"
#include "spectrum/viewing_conditions.h"

namespace emulsion {
namespace {

/// Pixels of the pictures that are compared, and of the pilot: few, so that each has many samples.
constexpr int kPixels = 256;

Scene reduced(Scene scene) {
    const double side = std::sqrt(kPixels / (static_cast<double>(scene.film.width_px) * scene.film.height_px));
    scene.film.width_px = std::max(1, static_cast<int>(std::lround(side * scene.film.width_px)));
    scene.film.height_px = std::max(1, static_cast<int>(std::lround(side * scene.film.height_px)));
    scene.filter = BoxFilter{};
    return scene;
}

std::vector<XYZd> picture(PreparedScene& scene, const TransportModel& model, int samples, std::uint64_t seed) {
    scene.prepare_for(model);
    Film film(film_options(scene.scene()));
    RenderProgress progress;
    render(scene, {.samples_per_pixel = samples, .seed = seed, .model = model, .threads = 0}, film, progress);
    std::vector<XYZd> pixels;
    const Image<XYZ> image = film.xyz_image();
    for (const XYZ& p : image.pixels()) pixels.push_back({p.x, p.y, p.z});
    return pixels;
}

struct Error {
    double mean = 0.0, p99 = 0.0;
};

Error error_between(const std::vector<XYZd>& a, const std::vector<XYZd>& b, const ViewingConditions& viewing) {
    std::vector<double> errors;
    Error error;
    for (std::size_t i = 0; i < a.size(); ++i) {
        errors.push_back(difference(Ciede2000Difference{}, lab_as_viewed(a[i], viewing), lab_as_viewed(b[i], viewing)));
        error.mean += errors.back() / static_cast<double>(a.size());
    }
    std::sort(errors.begin(), errors.end());
    error.p99 = errors[static_cast<std::size_t>(std::ceil(0.99 * static_cast<double>(errors.size()))) - 1];
    return error;
}

std::vector<XYZd> mean_of(std::vector<XYZd> a, const std::vector<XYZd>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = 0.5 * (a[i] + b[i]);
    return a;
}

ViewingConditions viewing_of(const std::vector<XYZd>& reference) {
    double log_sum = 0.0, count = 0.0;
    for (const XYZd& p : reference) {
        if (!(p.y > 0.0)) continue;
        log_sum += std::log(p.y);
        count += 1.0;
    }
    return {default_white(cie_1931_2deg()), white_luminance_of_log_average(std::exp(log_sum / count))};
}

std::vector<std::string> bundled_scenes() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(EMULSION_SOURCE_DIR "/scenes")) {
        if (entry.path().extension() == ".pbrt") names.push_back(entry.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

/// The whole check of one scene. Two pictures by each model tell the noise that is left: that of their mean is half the
/// difference of the two, and it adds to the measured error in squares.
void expect_as_predicted(const std::string& name, int samples) {
    PreparedScene scene(reduced(read_scene(EMULSION_SOURCE_DIR "/scenes/" + name + ".pbrt")), 0);
    const ModelAnalysis analysis = analyse_models(scene, {}, {.pixels = kPixels, .samples_per_pixel = 256});
    const ModelPrediction& chosen = analysis.models[analysis.chosen];

    const TransportModel exact = SpectralModel{32};
    const std::vector<XYZd> reference_1 = picture(scene, exact, samples, 11),
                            reference_2 = picture(scene, exact, samples, 12);
    const std::vector<XYZd> test_1 = picture(scene, chosen.model, samples, 13),
                            test_2 = picture(scene, chosen.model, samples, 14);
    const std::vector<XYZd> reference = mean_of(reference_1, reference_2), test = mean_of(test_1, test_2);
    const ViewingConditions viewing = viewing_of(reference);
    const Error measured = error_between(reference, test, viewing);
    const Error noise_a = error_between(reference_1, reference_2, viewing),
                noise_b = error_between(test_1, test_2, viewing);
    const auto left = [](double a, double b) { return 0.5 * std::hypot(a, b); };
    const double noise_mean = left(noise_a.mean, noise_b.mean), noise_p99 = left(noise_a.p99, noise_b.p99);
    const auto without = [](double error, double noise) {
        return std::sqrt(std::max(0.0, error * error - noise * noise));
    };
    const double mean = without(measured.mean, noise_mean), p99 = without(measured.p99, noise_p99);

    const std::string found =
        fmt::format("{}: {} predicted {:.3f} / {:.3f}, measured {:.3f} / {:.3f}, noise left {:.3f} / {:.3f}", name,
                    to_text(chosen.model), chosen.mean, chosen.p99, mean, p99, noise_mean, noise_p99);
    ::testing::Test::RecordProperty(name, found);
    std::puts(found.c_str());
    // What noise is left makes the difference of the squares uncertain by about as much as itself.
    EXPECT_LE(mean, analysis.budget.mean + noise_mean) << found;
    EXPECT_LE(p99, analysis.budget.p99 + noise_p99) << found;
    const double slack = 0.2 + noise_mean, slack_p99 = 0.2 + noise_p99;
    EXPECT_TRUE((mean <= 2.0 * chosen.mean && chosen.mean <= 2.0 * mean) || std::abs(mean - chosen.mean) <= slack)
        << found;
    if (std::holds_alternative<SpectralModel>(chosen.model)) return;  // all that there is of it is noise
    EXPECT_TRUE((p99 <= 2.0 * chosen.p99 && chosen.p99 <= 2.0 * p99) || std::abs(p99 - chosen.p99) <= slack_p99)
        << found;
}

class MeasuredError : public ::testing::TestWithParam<std::string> {};
TEST_P(MeasuredError, IsAsPredicted) { expect_as_predicted(GetParam(), 1024); }
std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}
INSTANTIATE_TEST_SUITE_P(Scenes, MeasuredError, ::testing::ValuesIn(bundled_scenes()), test_name);

class LongMeasuredError : public ::testing::TestWithParam<std::string> {};
TEST_P(LongMeasuredError, IsAsPredicted) { expect_as_predicted(GetParam(), 16384); }
INSTANTIATE_TEST_SUITE_P(Long, LongMeasuredError, ::testing::ValuesIn(bundled_scenes()), test_name);

}  // namespace
}  // namespace emulsion
