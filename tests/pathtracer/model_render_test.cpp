// Whole renders by every transport model.

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analytic_scenes.h"
#include "channel_scene.h"
#include "core/named_value.h"
#include "film/film.h"
#include "pathtracer/render.h"
#include "spectrum/colorimetry.h"
#include "spectrum/named_spectra.h"

namespace emulsion::testing {
namespace {

using ::testing::HasSubstr;

constexpr int kSize_px = 16;

struct MeanXyz {
    XYZd mean{}, standard_error{};
};

MeanXyz mean_xyz(const PreparedScene& scene, const TransportModel& model, int samples, FilmOptions film_options = {}) {
    film_options.width_px = film_options.height_px = kSize_px;
    Film film(film_options);
    RenderProgress progress;
    render(scene, {.samples_per_pixel = samples, .seed = 5, .model = model, .threads = 1}, film, progress);
    const Image<XYZ> picture = film.xyz_image();
    XYZd sum{}, squares{};
    for (const XYZ& p : picture.pixels()) {
        const XYZd v{p.x, p.y, p.z};
        sum = sum + v;
        squares = squares + XYZd{v.x * v.x, v.y * v.y, v.z * v.z};
    }
    constexpr double kPixels = kSize_px * kSize_px;
    const auto error = [](double s, double q) {
        return std::sqrt(std::max(0.0, q / kPixels - s * s / (kPixels * kPixels)) / (kPixels - 1));
    };
    return {1.0 / kPixels * sum, {error(sum.x, squares.x), error(sum.y, squares.y), error(sum.z, squares.z)}};
}

/// All pixels see a plate of `reflectance` in the light of an even sky, no more than one reflection of which comes
/// back.
Scene plate(const Spectrum& reflectance, const Spectrum& sky) {
    Scene scene;
    scene.materials = {DiffuseMaterial{reflectance}};
    scene.shapes = {{parallelogram({-1e3f, -1e3f, 1}, {0, 2e3f, 0}, {2e3f, 0, 0}), 0, {}}};
    scene.lights = {UniformInfiniteLight{{sky, 0.01}}};
    scene.integrator.max_depth = 1;
    return scene;
}

void expect_near(const MeanXyz& found, const XYZd& expected, double tolerance, const std::string& what) {
    EXPECT_NEAR(found.mean.x, expected.x, 4.0 * found.standard_error.x + tolerance * expected.y) << what;
    EXPECT_NEAR(found.mean.y, expected.y, 4.0 * found.standard_error.y + tolerance * expected.y) << what;
    EXPECT_NEAR(found.mean.z, expected.z, 4.0 * found.standard_error.z + tolerance * expected.y) << what;
}

TEST(ModelRender, EveryModelHasTheColourOfOneReflection) {
    const Spectrum light = catalogue_spectrum("FL11"), paint = catalogue_spectrum("colorchecker-orange");
    const XYZd expected = 0.01 * xyz_of_radiance(product_of(light, paint));
    PreparedScene scene(plate(paint, light), 1);
    std::vector<TransportModel> models = fixed_models();
    for_each_alternative<WavelengthStrategy>([&](auto strategy) {
        models.emplace_back(SpectralModel{4, strategy});
        models.emplace_back(SpectralModel{1, strategy});
    });
    for (const TransportModel& model : models) {
        if (std::holds_alternative<RgbModel>(model)) continue;  // not FL11's colours
        scene.prepare_for(model);
        const MeanXyz found = mean_xyz(scene, model, 64);
        expect_near(found, expected, 5e-4, to_text(model));
        EXPECT_LT(found.standard_error.y, 0.03 * expected.y) << to_text(model);
    }
    scene.prepare_for(RgbModel{});
    EXPECT_GT(std::abs(mean_xyz(scene, RgbModel{}, 16).mean.x - expected.x), 0.02 * expected.y);
}

/// A line without width has its nanometre, in every strategy that follows the light.
TEST(ModelRender, StrategiesFindLinesWithoutWidth) {
    const Spectrum lamp = sum_of(LineSpectrum{{Line{546.1, 20.0}, Line{435.8, 10.0}}, {}}, ConstantSpectrum{0.1});
    const XYZd expected = 0.01 * xyz_of_radiance(lamp);
    for (const WavelengthStrategy& strategy : {WavelengthStrategy{HeroIlluminant{}}, WavelengthStrategy{HeroLines{}}}) {
        const TransportModel model = SpectralModel{4, strategy};
        const PreparedScene scene(plate(ConstantSpectrum{1.0}, lamp), 1, model);
        const MeanXyz found = mean_xyz(scene, model, 64);
        expect_near(found, expected, 1e-3, to_text(model));
        EXPECT_LT(found.standard_error.y, 0.005 * expected.y) << to_text(model);
    }
}

TEST(ModelRender, MetalsHaveTheirReflectance) {
    const Spectrum light = catalogue_spectrum("D65");
    Scene gold = plate(ConstantSpectrum{0.0}, light);
    gold.materials = {
        ConductorMaterial{ComplexIor{*named_spectrum("metal-Au-eta"), catalogue_spectrum("metal-Au-k")}, {}}};
    const XYZd expected = 0.01 * xyz_of_radiance(product_of(light, normal_reflectance(*named_spectrum("metal-Au-eta"),
                                                                                      *named_spectrum("metal-Au-k"))));
    std::get<PerspectiveCamera>(gold.camera).fov_deg = 5.0;
    PreparedScene scene(gold, 1);
    for (const TransportModel& model : fixed_models()) {
        if (model == TransportModel{RgbModel{}}) continue;  // gold is outside of its gamut
        scene.prepare_for(model);
        expect_near(mean_xyz(scene, model, 4), expected, 2e-3, to_text(model));
    }
}

/// What disperses in paths of wavelengths keeps all its channels in the others.
TEST(ModelRender, GlassKeepsAllChannels) {
    Scene scene = plate(ConstantSpectrum{0.0}, ConstantSpectrum{1.0});
    for (const double roughness : {0.0, 0.3}) {
        scene.materials = {DielectricMaterial{slope(1.6, 1.5), {roughness, roughness}}};
        scene.integrator.max_depth = 3;
        PreparedScene prepared(scene, 1);
        const XYZd sky = 0.01 * xyz_of_radiance(ConstantSpectrum{1.0});
        for (const TransportModel& model : fixed_models()) {
            prepared.prepare_for(model);
            const MeanXyz found = mean_xyz(prepared, model, 64);
            // Rough facets lose what bounces between them: all channels alike.
            EXPECT_NEAR(found.mean.x / found.mean.y, sky.x / sky.y, 1e-3) << to_text(model);
            EXPECT_NEAR(found.mean.z / found.mean.y, sky.z / sky.y, 1e-3) << to_text(model);
            // Behind the surface everything is glass: radiance there is seen over the square of its index.
            EXPECT_GT(found.mean.y, 0.35 * sky.y) << to_text(model);
        }
    }
}

TEST(ModelRender, RefusesWhatItIsNotPreparedFor) {
    const PreparedScene scene(plate(ConstantSpectrum{0.5}, ConstantSpectrum{1.0}), 1, RgbModel{});
    EXPECT_TRUE(scene.is_prepared_for(SpectralModel{}));
    EXPECT_FALSE(scene.is_prepared_for(RgbModel{"Rec2020"}));
    const auto message = [&scene](const TransportModel& model, const FilmOptions& film = {}) -> std::string {
        try {
            static_cast<void>(mean_xyz(scene, model, 1, film));
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "rendered";
    };
    EXPECT_THAT(message(RgbModel{"Rec2020"}), HasSubstr("the scene is not prepared for rgb:Rec2020"));
    EXPECT_THAT(message(SpectralModel{4, HeroIlluminant{}}), HasSubstr("not prepared"));
    EXPECT_EQ(message(RgbModel{}), "rendered");
    FilmOptions other;
    other.sensor.observer = "cie_1964_10deg";
    EXPECT_THAT(message(RgbModel{}, other), HasSubstr("is of observer cie_1964_10deg"));
    FilmOptions buckets;
    buckets.spectrum = SpectralBuckets{};
    EXPECT_THAT(message(RgbModel{}, buckets), HasSubstr("has spectral buckets"));
}

}  // namespace
}  // namespace emulsion::testing
