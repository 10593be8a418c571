// Densities of the emitters against what is drawn: each sample's 1/pdf must add up to the solid angle that the light
// covers, and the density that a ray finds by chance must be the one that it would have been drawn with.

#include "pathtracer/emitters.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "analytic_scenes.h"
#include "core/random.h"

namespace emulsion::testing {
namespace {

constexpr double kPi = std::numbers::pi;

TriangleEmitter triangle_emitter() {
    TriangleMesh mesh;
    mesh.position = {{-1, -1, 2}, {-1, 2, 2}, {3, -1, 2.5}};
    mesh.triangle = {{0, 1, 2}};
    return {TriangleGeometry(mesh, 0), false};
}

Sphere sphere_at(const Imath::V3d& centre, double radius, const Imath::V3d& stretch = {1, 1, 1}) {
    Imath::M44d world_from_object;
    world_from_object.setScale(stretch);
    for (int i = 0; i < 3; ++i) world_from_object[3][i] = centre[i];
    return {world_from_object, radius, false};
}

/// Mean of 1/pdf over the samples, with its standard error: the solid angle.
struct SolidAngle {
    double mean, standard_error;
};

SolidAngle measured_solid_angle(const EmitterGeometry& emitter, const Imath::V3f& from) {
    constexpr int kCount = 100000;
    Pcg32 random(5);
    double sum = 0.0, sum_of_squares = 0.0;
    for (int i = 0; i < kCount; ++i) {
        const float u = random.next_float();
        const EmitterSample light = sample(emitter, from, {u, random.next_float()});
        if (light.scale == 0.0f) continue;
        const double inverse = 1.0 / static_cast<double>(light.pdf);
        sum += inverse;
        sum_of_squares += inverse * inverse;
        EXPECT_NEAR(light.to_light.length(), 1.0f, 1e-5f);
    }
    const double mean = sum / kCount;
    return {mean, std::sqrt(std::max(0.0, sum_of_squares / kCount - mean * mean) / kCount)};
}

/// Van Oosterom & Strackee, "The Solid Angle of a Plane Triangle", IEEE Trans. Biomed. Eng. 30 (1983).
double triangle_solid_angle(const TriangleGeometry& t, const Imath::V3f& from) {
    const Imath::V3d a = Imath::V3d(t.p0 - from).normalized(), b = Imath::V3d(t.p0 + t.edge1 - from).normalized(),
                     c = Imath::V3d(t.p0 + t.edge2 - from).normalized();
    return 2.0 * std::atan2(std::abs(a.dot(b.cross(c))), 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
}

TEST(Emitters, TriangleCoversItsSolidAngle) {
    const TriangleEmitter emitter = triangle_emitter();
    for (const Imath::V3f& from : {Imath::V3f(0, 0, 0), Imath::V3f(1, 3, 1.5f), Imath::V3f(-4, 0, 1)}) {
        const SolidAngle measured = measured_solid_angle(emitter, from);
        EXPECT_NEAR(measured.mean, triangle_solid_angle(emitter.triangle, from), 4.0 * measured.standard_error + 1e-5);
    }
}

TEST(Emitters, SphereCoversItsCone) {
    const SphereEmitter emitter{PreparedSphere(sphere_at({0, 0, 5}, 1.5))};
    for (const Imath::V3f& from : {Imath::V3f(0, 0, 0), Imath::V3f(0, 0, 3.4f), Imath::V3f(100, 50, -200)}) {
        const double distance2 = (Imath::V3d(from) - Imath::V3d(0, 0, 5)).length2(), sin2 = 1.5 * 1.5 / distance2;
        const SolidAngle measured = measured_solid_angle(emitter, from);
        const double expected = 2.0 * kPi * sin2 / (1.0 + std::sqrt(1.0 - sin2));
        EXPECT_NEAR(measured.mean, expected, 4.0 * measured.standard_error + 1e-5 * expected);
    }
}

/// From inside, a sphere that emits inwards fills every direction.
TEST(Emitters, SphereOrEllipsoidAroundCoversEverything) {
    for (const Imath::V3d& stretch : {Imath::V3d(1, 1, 1), Imath::V3d(0.5, 2, 1)}) {
        SphereEmitter emitter{PreparedSphere(sphere_at({0, 0, 0}, 2.0, stretch))};
        emitter.sphere.flip_normal = true;
        const SolidAngle measured = measured_solid_angle(emitter, {0.3f, -0.5f, 0.2f});
        EXPECT_NEAR(measured.mean, 4.0 * kPi, 4.0 * measured.standard_error);
    }
}

/// The two halves of multiple importance sampling must speak of the same density.
TEST(Emitters, DensityOfAHitIsThatOfTheSample) {
    const EmitterGeometry emitters[] = {triangle_emitter(), SphereEmitter{PreparedSphere(sphere_at({0, 0, 5}, 1.5))},
                                        SphereEmitter{PreparedSphere(sphere_at({0, 0, 5}, 1.0, {2, 0.5, 1}))}};
    Pcg32 random(9);
    for (const EmitterGeometry& emitter : emitters) {
        const Imath::V3f from(0.2f, 0.1f, 0.0f);
        for (int i = 0; i < 1000; ++i) {
            const float u = random.next_float();
            const EmitterSample light = sample(emitter, from, {u, random.next_float()});
            if (light.scale == 0.0f) continue;
            Imath::V3f normal;
            if (const auto* triangle = std::get_if<TriangleEmitter>(&emitter)) {
                normal = triangle->triangle.normal;
            } else {
                normal = Imath::V3f(point_at(std::get<SphereEmitter>(emitter).sphere, Imath::V3d(light.target)).normal);
            }
            // Where the light is seen edge-on, rounding of the normal shows in the density.
            const float cosine = std::abs(light.to_light.dot(normal));
            if (cosine < 0.05f) continue;
            const float pdf = direction_pdf(emitter, from, light.to_light, light.target, normal);
            EXPECT_NEAR(pdf / light.pdf, 1.0f, 1e-3f);
        }
    }
}

TEST(EmitterPicker, PicksInProportion) {
    const std::vector<double> weights = {1.0, 0.0, 5.0, 2.5, 1e-3, 10.0, 3.0};
    const EmitterPicker picker(weights);
    constexpr int kCount = 1 << 20;
    std::vector<double> picked(weights.size());
    for (int i = 0; i < kCount; ++i) ++picked[picker.pick((i + 0.5) / kCount)];
    double total = 0.0;
    for (const double weight : weights) total += weight;
    // Evenly spread numbers: each cell of the table is off by at most two of them.
    for (std::size_t i = 0; i < weights.size(); ++i) {
        EXPECT_NEAR(picked[i] / kCount, weights[i] / total, 2.0 * static_cast<double>(weights.size()) / kCount) << i;
    }
    EXPECT_EQ(picked[1], 0.0);
}

/// Among 100,001 emitters, one of which has a third of the weight: with the 24 bits of a float it would get 0.7% less.
TEST(EmitterPicker, PicksInProportionAmongMany) {
    std::vector<double> weights(100001, 1.0);
    weights[777] = 50000.0;
    const EmitterPicker picker(weights);
    constexpr int kCount = 1 << 22;
    int picked = 0;
    for (int i = 0; i < kCount; ++i) {
        SampleSequence sequence(IndependentSampler{}, 1, 0, 0, i);
        picked += picker.pick(sequence.next_1d_fine()) == 777 ? 1 : 0;
    }
    const double expected = 50000.0 / 150000.0, error = std::sqrt(expected * (1.0 - expected) / kCount);
    EXPECT_NEAR(static_cast<double>(picked) / kCount, expected, 4.5 * error);  // 0.3%; by chance 7e-6
}

}  // namespace
}  // namespace emulsion::testing
