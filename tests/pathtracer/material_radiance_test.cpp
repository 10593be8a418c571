// Materials in scenes whose radiance is known: through parser's values, integrator and lights together.

#include <numbers>

#include <gtest/gtest.h>

#include "analytic_scenes.h"
#include "pathtracer/fresnel.h"

namespace emulsion::testing {
namespace {

constexpr double kPi = std::numbers::pi;

void expect_radiance(const RadianceEstimate& estimate, const std::array<double, 4>& expected) {
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(estimate.mean[i], expected[i], 4.5 * estimate.standard_error[i] + 1e-5 * expected[i])
            << kTestWavelengths_nm[i] << " nm";
    }
}

template <class F>
std::array<double, 4> at_wavelengths(const F& f) {
    std::array<double, 4> values{};
    for (std::size_t i = 0; i < 4; ++i) values[i] = f(static_cast<double>(kTestWavelengths_nm[i]));
    return values;
}

/// The unit sphere of a material under a uniform sky.
Scene ball_under_sky(const Material& material, const Spectrum& sky) {
    Scene scene;
    scene.materials = {material};
    scene.shapes = {{Sphere{}, 0, {}}};
    scene.lights = {UniformInfiniteLight{{sky, 1.0}}};
    scene.integrator.max_depth = 1000;
    return scene;
}

const Ray kPastTheCentre = {{-5.0f, 0.4f, 0.3f}, {1.0f, 0.0f, 0.0f}};
const PiecewiseLinearSpectrum kSky = slope(2.0, 5.0);

// What takes nothing away cannot be told from the sky.
TEST(MaterialRadiance, ClearThingsVanishUnderAUniformSky) {
    const auto sky = at_wavelengths([](double lambda_nm) { return eval(kSky, lambda_nm); });
    const Material glass = DielectricMaterial{}, pane = ThinDielectricMaterial{},
                   paper = DiffuseTransmissionMaterial{Spectrum(ConstantSpectrum{0.5}), Spectrum(ConstantSpectrum{0.5}),
                                                       1.0},
                   snow = DiffuseMaterial{Spectrum(ConstantSpectrum{1.0})};
    for (const Material& material : {glass, pane, paper, snow}) {
        SCOPED_TRACE(material.index());
        expect_radiance(estimate_radiance(ball_under_sky(material, kSky), kPastTheCentre, 4000), sky);
    }
}

// Rough glass loses what its facets lose; little, if it is nearly smooth.
TEST(MaterialRadiance, NearlySmoothGlassNearlyVanishes) {
    DielectricMaterial glass;
    glass.roughness = {0.02, 0.02, false};
    const auto estimate = estimate_radiance(ball_under_sky(glass, ConstantSpectrum{1.0}), kPastTheCentre, 100000);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(estimate.mean[i], 1.0, 0.005 + 4.5 * estimate.standard_error[i]);
    }
}

TEST(MaterialRadiance, MirrorsMultiplyByTheFresnelReflectance) {
    const ComplexIor gold{slope(1.5, 0.2), slope(1.9, 4.0)};
    const Ray ray = {{-5.0f, 0.6f, 0.0f}, {1.0f, 0.0f, 0.0f}};  // meets the sphere at a cosine of 0.8
    expect_radiance(estimate_radiance(ball_under_sky(ConductorMaterial{gold, {}}, kSky), ray, 100),
                    at_wavelengths([&](double lambda_nm) {
                        return eval(kSky, lambda_nm) *
                               fresnel_conductor(0.8, eval(gold.eta, lambda_nm), eval(gold.k, lambda_nm));
                    }));
    // By its reflectance at normal incidence, there.
    const ReflectanceParameter red = Spectrum(slope(0.1, 0.95));
    expect_radiance(
        estimate_radiance(ball_under_sky(ConductorMaterial{red, {}}, kSky), {{-5, 0, 0}, {1, 0, 0}}, 100),
        at_wavelengths([&](double lambda_nm) { return eval(kSky, lambda_nm) * eval(slope(0.1, 0.95), lambda_nm); }));
}

// A pane before a lamp, on black: 2R / (1 + R) of what is behind the eye, and the rest of the lamp.
TEST(MaterialRadiance, PanesReflectAndLetThrough) {
    Scene scene;
    scene.materials = {ThinDielectricMaterial{ConstantSpectrum{1.5}}, DiffuseMaterial{Spectrum(ConstantSpectrum{0.0})}};
    scene.shapes = {{parallelogram({-9, -9, 1}, {0, 18, 0}, {18, 0, 0}), 0, {}},
                    {parallelogram({-9, -9, 2}, {0, 18, 0}, {18, 0, 0}), 1, AreaLight{{ConstantSpectrum{3.0}, 1.0}}},
                    {parallelogram({-9, -9, -1}, {18, 0, 0}, {0, 18, 0}), 1, AreaLight{{ConstantSpectrum{1.0}, 1.0}}}};
    scene.integrator.max_depth = 5;
    const double r = fresnel_dielectric(0.8, 1.5), reflected = 2.0 * r / (1.0 + r);
    const auto estimate = estimate_radiance(scene, {{0, 0, 0}, {0.6f, 0.0f, 0.8f}}, 100000);
    expect_radiance(estimate, at_wavelengths([&](double) { return reflected * 1.0 + (1.0 - reflected) * 3.0; }));
}

// Paper under a lamp seen from below: transmittance times irradiance over pi.
TEST(MaterialRadiance, PaperShowsTheLightBehindIt) {
    const PiecewiseLinearSpectrum reflectance = slope(0.1, 0.2), transmittance = slope(0.3, 0.7);
    Scene scene;
    scene.materials = {DiffuseTransmissionMaterial{Spectrum(reflectance), Spectrum(transmittance), 1.0}};
    scene.shapes = {{parallelogram({-9, -9, 0}, {18, 0, 0}, {0, 18, 0}), 0, {}}};
    scene.lights = {DistantLight{{0.6, 0.0, 0.8}, {kSky, 1.0}}};
    scene.integrator.max_depth = 1;
    for (const bool below : {false, true}) {
        const float side = below ? -1.0f : 1.0f;
        expect_radiance(estimate_radiance(scene, {{0, 0, side}, {0, 0, -side}}, 1000),
                        at_wavelengths([&](double lambda_nm) {
                            const double share = eval(below ? transmittance : reflectance, lambda_nm);
                            return share * 0.8 * eval(kSky, lambda_nm) / kPi;
                        }));
    }
}

// A furnace whose walls are a mix has the mean of the albedos, even of mixes of mixes.
TEST(MaterialRadiance, MixesHaveTheMeanAlbedo) {
    Scene scene;
    scene.materials = {MixMaterial{1, 2, 0.25}, DiffuseMaterial{Spectrum(ConstantSpectrum{0.2})},
                       MixMaterial{3, 1, 0.5}, DiffuseMaterial{Spectrum(ConstantSpectrum{0.8})}};
    scene.shapes = {{inward_box(), 0, AreaLight{{kSky, 1.0}}}};
    scene.integrator.max_depth = 10000;
    const double albedo = 0.75 * 0.2 + 0.25 * (0.5 * 0.8 + 0.5 * 0.2);
    expect_radiance(estimate_radiance(scene, {{0.1f, 0.2f, 0.3f}, {0, 0.6f, 0.8f}}, 40000),
                    at_wavelengths([&](double lambda_nm) { return eval(kSky, lambda_nm) / (1.0 - albedo); }));
}

// Lamps light rough metal and varnish by their shadow rays and by chance: a sky of the same radiance shows whether the
// two share the work rightly, for with the sky alone every path ends in it.
TEST(MaterialRadiance, LightSamplingAgreesWithChance) {
    const Material metal =
        ConductorMaterial{ComplexIor{ConstantSpectrum{1.2}, ConstantSpectrum{2.6}}, {0.3, 0.1, false}};
    CoatedDiffuseMaterial varnish;
    varnish.roughness = {0.2, 0.2, false};
    for (const Material& material : {metal, Material(varnish)}) {
        Scene by_sky = ball_under_sky(material, ConstantSpectrum{1.0});
        by_sky.integrator.max_depth = 1;
        // The same radiance from a closed sphere around all, as many area lights and one light to pick.
        Scene by_shell = by_sky;
        by_shell.lights.clear();
        by_shell.materials.push_back(DiffuseMaterial{Spectrum(ConstantSpectrum{0.0})});
        by_shell.shapes.push_back({Sphere{.world_from_object = {}, .radius = 30.0, .flip_normal = true}, 1,
                                   AreaLight{{ConstantSpectrum{1.0}, 1.0}}});
        const auto sky = estimate_radiance(by_sky, kPastTheCentre, 60000);
        const auto shell = estimate_radiance(by_shell, kPastTheCentre, 60000);
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_NEAR(sky.mean[i], shell.mean[i], 4.5 * std::hypot(sky.standard_error[i], shell.standard_error[i]));
            EXPECT_LT(sky.standard_error[i], 0.01 * sky.mean[i]);
        }
    }
}

TEST(MaterialRadiance, RefusesEndlessMixes) {
    Scene scene;
    scene.materials = {MixMaterial{0, 0, 0.5}};
    EXPECT_THROW(PreparedScene(scene, 1), std::invalid_argument);
    scene.materials = {MixMaterial{1, 1, 0.5}, MixMaterial{0, 0, 0.5}};
    EXPECT_THROW(PreparedScene(scene, 1), std::invalid_argument);
    scene.materials = {MixMaterial{0, 7, 0.5}};
    EXPECT_THROW(PreparedScene(scene, 1), std::invalid_argument);
}

}  // namespace
}  // namespace emulsion::testing
