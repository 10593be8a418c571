// A diffuse floor of reflectance r seen from above has radiance r E / pi: the irradiance E of each kind of light
// against its closed form.

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "analytic_scenes.h"

namespace emulsion::testing {
namespace {

constexpr double kPi = std::numbers::pi;

/// A floor in the plane z = 0, normal upwards.
Scene floor_scene(const Spectrum& reflectance) {
    Scene scene;
    scene.materials = {DiffuseMaterial{reflectance}};
    scene.shapes = {{parallelogram({-50, -50, 0}, {100, 0, 0}, {0, 100, 0}), 0, {}}};
    scene.integrator.max_depth = 1;
    return scene;
}

/// Looks at the point (x, y, 0) of the floor, askance.
Ray towards_floor(float x, float y) {
    const Imath::V3f eye(x + 0.3f, y - 0.1f, 0.5f);
    return {eye, (Imath::V3f(x, y, 0) - eye).normalized()};
}

class Irradiance : public ::testing::TestWithParam<Sampler> {
  protected:
    void expect_irradiance(const Scene& scene, float x, float y, const Spectrum& reflectance, const Spectrum& emission,
                           double irradiance_of_unit_emission, int count = 100000, double rounding = 4e-6) const {
        const auto estimate = estimate_radiance(scene, towards_floor(x, y), count, GetParam());
        for (std::size_t i = 0; i < 4; ++i) {
            const auto lambda_nm = static_cast<double>(kTestWavelengths_nm[i]);
            const double expected =
                eval(reflectance, lambda_nm) * eval(emission, lambda_nm) * irradiance_of_unit_emission / kPi;
            EXPECT_NEAR(estimate.mean[i], expected, 4.0 * estimate.standard_error[i] + rounding * expected)
                << lambda_nm << " nm";
            EXPECT_LT(estimate.standard_error[i], 0.005 * expected);
        }
    }

    const PiecewiseLinearSpectrum reflectance_ = slope(0.2, 0.9), emission_ = slope(3.0, 1.0);
};

TEST_P(Irradiance, PointLightFollowsCosineAndInverseSquare) {
    Scene scene = floor_scene(reflectance_);
    scene.lights = {PointLight{{1.0, 2.0, 3.0}, {emission_, 1.0}}};
    const double distance2 = 14.0, cosine = 3.0 / std::sqrt(distance2);
    expect_irradiance(scene, 0.0f, 0.0f, reflectance_, emission_, cosine / distance2, 100);
}

TEST_P(Irradiance, SpotLightFadesTowardsItsEdge) {
    Scene scene = floor_scene(reflectance_);
    // 2 above the floor, shining straight down: at x the cosine to the axis is that of the floor.
    SpotLight spot;
    spot.position = {0.0, 0.0, 2.0};
    spot.light_from_world = Imath::M44d(1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1);
    spot.intensity = {emission_, 1.0};
    spot.cos_full = 0.9;
    spot.cos_none = 0.7;
    scene.lights = {spot};
    const auto irradiance = [](double x) {
        const double distance2 = x * x + 4.0, cosine = 2.0 / std::sqrt(distance2);
        const double t = std::clamp((cosine - 0.7) / (0.9 - 0.7), 0.0, 1.0);
        return t * t * (3.0 - 2.0 * t) * cosine / distance2;
    };
    // The falloff magnifies the rounding of the cosine (some 2^-23) by its relative slope, up to 80 close to the edge.
    for (const float x : {0.0f, 0.5f, 1.2f, 1.5f, 1.9f}) {
        expect_irradiance(scene, x, 0.0f, reflectance_, emission_, irradiance(static_cast<double>(x)), 100, 2e-5);
    }
    const auto outside = estimate_radiance(scene, towards_floor(2.1f, 0.0f), 100, GetParam());
    for (const double radiance : outside.mean) EXPECT_EQ(radiance, 0.0);
    // Nothing goes up.
    spot.light_from_world = Imath::M44d();
    scene.lights = {spot};
    for (const double radiance : estimate_radiance(scene, towards_floor(0, 0), 100, GetParam()).mean) {
        EXPECT_EQ(radiance, 0.0);
    }
}

TEST_P(Irradiance, DistantLightFollowsCosine) {
    Scene scene = floor_scene(reflectance_);
    scene.lights = {DistantLight{{0.6, 0.0, 0.8}, {emission_, 1.0}}};
    expect_irradiance(scene, 2.0f, 1.0f, reflectance_, emission_, 0.8, 100);
}

TEST_P(Irradiance, UniformSkyGivesPi) {
    Scene scene = floor_scene(reflectance_);
    scene.lights = {UniformInfiniteLight{{emission_, 1.0}}};
    expect_irradiance(scene, 0.0f, 0.0f, reflectance_, emission_, kPi);
}

/// Above the origin: the rectangle [-1, 3] x [-2, 1] at height 2, facing down.
Scene rectangle_scene(const Spectrum& reflectance, const Spectrum& emission) {
    Scene scene = floor_scene(reflectance);
    scene.materials.emplace_back(DiffuseMaterial{ConstantSpectrum{0.0}});
    scene.shapes.push_back({parallelogram({-1, -2, 2}, {0, 3, 0}, {4, 0, 0}), 1, AreaLight{{emission, 1.0}}});
    return scene;
}

TEST_P(Irradiance, RectangularAreaLightMatchesItsFormFactor) {
    const double form_factor = corner_form_factor(1.5, 0.5) + corner_form_factor(1.5, 1.0) +
                               corner_form_factor(0.5, 0.5) + corner_form_factor(0.5, 1.0);
    expect_irradiance(rectangle_scene(reflectance_, emission_), 0.0f, 0.0f, reflectance_, emission_, kPi * form_factor);
}

TEST_P(Irradiance, AreaLightIsDarkFromBehindUnlessTwoSided) {
    Scene scene = rectangle_scene(reflectance_, emission_);
    auto& mesh = std::get<TriangleMesh>(scene.shapes[1].geometry);
    mesh.flip_normal = true;
    const auto behind = estimate_radiance(scene, towards_floor(0, 0), 1000, GetParam());
    for (const double mean : behind.mean) EXPECT_EQ(mean, 0.0);

    scene.shapes[1].area_light->two_sided = true;
    const double form_factor = corner_form_factor(1.5, 0.5) + corner_form_factor(1.5, 1.0) +
                               corner_form_factor(0.5, 0.5) + corner_form_factor(0.5, 1.0);
    expect_irradiance(scene, 0.0f, 0.0f, reflectance_, emission_, kPi * form_factor);
}

TEST_P(Irradiance, TrianglesOfOneMeshMayDifferInRadiance) {
    Scene both = rectangle_scene(reflectance_, emission_), first = both;
    both.shapes[1].area_light->triangle_scale = {1.0f, 0.25f};
    first.shapes[1].area_light->triangle_scale = {1.0f, 0.0f};
    Scene second = first;
    second.shapes[1].area_light->triangle_scale = {0.0f, 1.0f};
    const auto mixed = estimate_radiance(both, towards_floor(0, 0), 40000, GetParam());
    const auto one = estimate_radiance(first, towards_floor(0, 0), 40000, GetParam(), 2);
    const auto other = estimate_radiance(second, towards_floor(0, 0), 40000, GetParam(), 3);
    for (std::size_t i = 0; i < 4; ++i) {
        const double error = std::hypot(mixed.standard_error[i], one.standard_error[i], 0.25 * other.standard_error[i]);
        EXPECT_NEAR(mixed.mean[i], one.mean[i] + 0.25 * other.mean[i], 4.0 * error);
        EXPECT_GT(one.mean[i], 0.0);
    }
}

TEST_P(Irradiance, SphericalAreaLightIsThatOfItsSolidAngle) {
    for (const double stretch : {1.0, 1.0 + 1e-6}) {  // the second is no similarity: sampled by area
        Scene scene = floor_scene(reflectance_);
        scene.materials.emplace_back(DiffuseMaterial{ConstantSpectrum{0.0}});
        Imath::M44d world_from_object;
        world_from_object.setScale(Imath::V3d(stretch, 1.0, 1.0));
        world_from_object[3][2] = 3.0;
        scene.shapes.push_back({Sphere{world_from_object, 1.5}, 1, AreaLight{{emission_, 1.0}}});
        expect_irradiance(scene, 0.0f, 0.0f, reflectance_, emission_, kPi * 0.25);
    }
}

/// An ellipsoid and a long thin box around it look alike from nowhere; against a fine mesh of the same surface they do.
TEST_P(Irradiance, EllipsoidAreaLightMatchesItsMesh) {
    Imath::M44d world_from_object;
    world_from_object.setScale(Imath::V3d(2.0, 0.5, 1.0));
    world_from_object[3][1] = 0.7;
    world_from_object[3][2] = 2.0;
    Scene scene = floor_scene(reflectance_);
    scene.shapes.push_back({Sphere{world_from_object, 1.0}, 0, AreaLight{{emission_, 1.0}}});

    TriangleMesh mesh;
    constexpr std::uint32_t kRings = 100, kSegments = 200;
    for (std::uint32_t i = 0; i <= kRings; ++i) {
        for (std::uint32_t j = 0; j < kSegments; ++j) {
            const double theta = kPi * i / kRings, phi = 2.0 * kPi * j / kSegments;
            const Imath::V3d on_sphere(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                       std::cos(theta));
            Imath::V3d world;
            world_from_object.multVecMatrix(on_sphere, world);
            mesh.position.emplace_back(world);
            if (i == kRings) continue;
            const std::uint32_t a = i * kSegments + j, b = i * kSegments + (j + 1) % kSegments;
            if (i > 0) mesh.triangle.push_back({a, a + kSegments, b});
            if (i + 1 < kRings) mesh.triangle.push_back({b, a + kSegments, b + kSegments});
        }
    }
    Scene meshed = scene;
    meshed.shapes.back().geometry = mesh;
    const auto smooth = estimate_radiance(scene, towards_floor(0, 0), 40000, GetParam());
    const auto faceted = estimate_radiance(meshed, towards_floor(0, 0), 40000, GetParam());
    for (std::size_t i = 0; i < 4; ++i) {
        const double error = std::hypot(smooth.standard_error[i], faceted.standard_error[i]);
        // The mesh is inscribed: smaller by about (pi/100)^2/3 across.
        EXPECT_NEAR(smooth.mean[i], faceted.mean[i], 4.0 * error + 4e-4 * smooth.mean[i]);
    }
}

TEST_P(Irradiance, LightsAddUp) {
    Scene scene = rectangle_scene(reflectance_, emission_);
    scene.lights = {PointLight{{1.0, 0.5, 1.5}, {emission_, 4.0}}, DistantLight{{0.0, 0.8, 0.6}, {emission_, 0.3}}};
    const double form_factor = corner_form_factor(1.5, 0.5) + corner_form_factor(1.5, 1.0) +
                               corner_form_factor(0.5, 0.5) + corner_form_factor(0.5, 1.0);
    const double distance2 = 1.0 + 0.25 + 2.25;
    // The distant light comes in under the rectangle's edge at y = 1: at height 2 its ray is at y = 2.67.
    const double irradiance = kPi * form_factor + 4.0 * 1.5 / std::sqrt(distance2) / distance2 + 0.3 * 0.6;
    expect_irradiance(scene, 0.0f, 0.0f, reflectance_, emission_, irradiance);
}

TEST_P(Irradiance, SomethingInBetweenCastsAShadow) {
    Scene scene = floor_scene(reflectance_);
    scene.lights = {PointLight{{0.0, 0.0, 3.0}, {emission_, 1.0}}};
    scene.shapes.push_back({parallelogram({-1, -1, 2}, {2, 0, 0}, {0, 2, 0}), 0, {}});
    for (const double mean : estimate_radiance(scene, towards_floor(0, 0), 100, GetParam()).mean) EXPECT_EQ(mean, 0.0);
    // The shadow's edge lies at |x| = 3: just outside it is light.
    EXPECT_GT(estimate_radiance(scene, towards_floor(3.01f, 0), 100, GetParam()).mean[0], 0.0);
    EXPECT_EQ(estimate_radiance(scene, towards_floor(2.99f, 0), 100, GetParam()).mean[0], 0.0);
}

std::string sampler_name(const ::testing::TestParamInfo<Sampler>& info) {
    const char* const names[] = {"Independent", "Stratified", "PaddedSobol"};
    return names[info.param.index()];
}

INSTANTIATE_TEST_SUITE_P(Samplers, Irradiance,
                         ::testing::Values(IndependentSampler{}, StratifiedSampler{100, 200}, PaddedSobolSampler{}),
                         sampler_name);

}  // namespace
}  // namespace emulsion::testing
