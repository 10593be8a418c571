// Shapes as lights: each sample's 1/pdf must add up to the solid angle that rays find the light in, and the density
// that such a ray is given must be the one that it would have been drawn with.

#include "pathtracer/emitters_area.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "pathtracer/prepared_scene.h"
#include "scene_text.h"

namespace emulsion::testing {
namespace {

constexpr double kPi = std::numbers::pi;

struct LightCase {
    std::string name, shape;
    Imath::V3f from;
};

std::string name_of(const ::testing::TestParamInfo<LightCase>& info) { return info.param.name; }

class AreaEmitter : public ::testing::TestWithParam<LightCase> {
  protected:
    PreparedScene scene_{parse_world("AreaLightSource \"diffuse\" " + GetParam().shape), 1};

    [[nodiscard]] Hit hit_of(const Ray& ray) const {
        Hit hit;
        scene_.accelerator().intersect({&ray, 1}, {&hit, 1});
        return hit;
    }
    [[nodiscard]] bool is_lit_side(const Ray& ray, const SurfacePoint& point, std::uint32_t shape) const {
        return scene_.shape(shape).two_sided || ray.direction.dot(point.geometric_normal) < 0.0f;
    }
};

/// Mean of a quantity and its standard error.
struct Mean {
    double sum = 0.0, sum_of_squares = 0.0;
    int count = 0;

    void add(double value) {
        sum += value;
        sum_of_squares += value * value;
        ++count;
    }
    [[nodiscard]] double mean() const { return sum / count; }
    [[nodiscard]] double standard_error() const {
        return std::sqrt(std::max(0.0, sum_of_squares / count - mean() * mean()) / count);
    }
};

TEST_P(AreaEmitter, SamplesCoverTheSolidAngleInWhichRaysFindIt) {
    constexpr int kCount = 60000;
    const Imath::V3f from = GetParam().from;
    Pcg32 random(5);
    Mean sampled, found;
    for (int i = 0; i < kCount; ++i) {
        double inverse = 0.0;
        for (const Emitter& emitter : scene_.emitters()) {
            const float u = random.next_float();
            const EmitterSample light = sample(emitter.geometry, from, {u, random.next_float()});
            if (light.scale == 0.0f) continue;
            const Ray shadow{from, light.target - from, 1.0f - 1e-4f};
            std::uint8_t occluded = 0;
            scene_.accelerator().occluded({&shadow, 1}, {&occluded, 1});
            if (occluded == 0) inverse += 1.0 / static_cast<double>(light.pdf);
        }
        sampled.add(inverse);
        const float u = random.next_float();
        const Ray ray{from, uniform_sphere({u, random.next_float()})};
        const Hit hit = hit_of(ray);
        const bool meets = hit.shape != Hit::kNone && is_lit_side(ray, surface_point(scene_, ray, hit), hit.shape);
        found.add(meets ? 4.0 * kPi : 0.0);
    }
    // 4.5 standard errors: by chance once in 150,000 cases.
    const double error = std::hypot(sampled.standard_error(), found.standard_error());
    EXPECT_GT(found.mean(), 0.02);
    EXPECT_NEAR(sampled.mean(), found.mean(), 4.5 * error);
}

TEST_P(AreaEmitter, DensityOfAHitIsThatOfTheSample) {
    const Imath::V3f from = GetParam().from;
    Pcg32 random(9);
    int compared = 0;
    for (int i = 0; i < 3000; ++i) {
        const auto number = static_cast<std::uint32_t>(i) % static_cast<std::uint32_t>(scene_.emitters().size());
        const float u = random.next_float();
        const EmitterSample light = sample(scene_.emitters()[number].geometry, from, {u, random.next_float()});
        if (light.scale == 0.0f) continue;
        EXPECT_NEAR(light.to_light.length(), 1.0f, 1e-6f);
        const Ray ray{from, light.to_light};
        const Hit hit = hit_of(ray);
        if (hit.shape == Hit::kNone || hit.primitive != number) continue;  // past an edge, or hidden by the shape
        const SurfacePoint point = surface_point(scene_, ray, hit);
        // Edge-on, rounding of the direction shows in the density; and a far point of the shape may hide behind a near.
        const float cosine = std::abs(light.to_light.dot(point.geometric_normal));
        if (cosine < 0.05f || (point.position - light.target).length() > 1e-3f) continue;
        const float pdf = direction_pdf(scene_.emitters()[number].geometry, from, light.to_light, point.position,
                                        point.geometric_normal);
        EXPECT_NEAR(pdf / light.pdf, 1.0f, 1e-3f);
        ++compared;
    }
    EXPECT_GT(compared, 300);
}

const LightCase kCases[] = {
    {"triangle", R"(Shape "trianglemesh" "point3 P" [-1 -1 2  -1 2 2  3 -1 2.5])", {0, 0, 0}},
    {"triangleFromTheSide", R"(Shape "trianglemesh" "point3 P" [-1 -1 2  -1 2 2  3 -1 2.5])", {1, 3, 1.5f}},
    {"trianglesTurnedByNormals",
     R"(Shape "trianglemesh" "point3 P" [-1 -1 2  3 -1 2.5  -1 2 2  -3 -3 2] "integer indices" [0 1 2  0 3 2]
        "normal N" [0 0 -1 0 0 -1 0 0 -1 0 0 -1])",
     {0, 0, 0}},
    {"rectangle", R"(Shape "bilinearmesh" "point3 P" [-1 -1 2  -1 1 2  1 -1 2  1 1 2])", {0.5f, 0, 0}},
    {"trapezium", R"(Shape "bilinearmesh" "point3 P" [-1 -1 2  -1 1 2  1 -3 2  1 4 2])", {0.5f, 0, 0}},
    {"bentPatch", R"(Shape "bilinearmesh" "point3 P" [-1 -1 2  -1 1 3  1 -3 3  1 2 2])", {0.5f, 0, 0}},
    {"bentPatchTwoSided",
     R"("bool twosided" true Shape "bilinearmesh" "point3 P" [-1 -1 2  -1 1 4  1 -1 4  1 1 2])",
     {2.5f, 0, 3.0f}},
    {"sphere", R"(Translate 0 0 5 Shape "sphere" "float radius" 1.5)", {0, 0, 0}},
    {"sphereCloseBy", R"(Translate 0 0 5 Shape "sphere" "float radius" 1.5)", {0, 0, 3.4f}},
    {"sphereFromInside", R"(ReverseOrientation Shape "sphere" "float radius" 2)", {0.3f, -0.5f, 0.2f}},
    {"sphereMirrored", R"(Scale -1 1 1 Translate 0 0 5 Shape "sphere" "float radius" 1.5)", {0, 0, 0}},
    {"ellipsoid", R"(Translate 0 0 5 Scale 2 0.5 1 Shape "sphere")", {0.2f, 0.1f, 0}},
    {"ellipsoidFromInside", R"(ReverseOrientation Scale 0.5 2 1 Shape "sphere" "float radius" 2)", {0.3f, -0.5f, 0.2f}},
    {"partOfASphere",
     R"("bool twosided" true Rotate 20 1 1 0 Shape "sphere" "float zmin" -0.4 "float zmax" 0.8 "float phimax" 250)",
     {0.5f, 2.0f, -0.5f}},
    {"disk", R"(Translate 0 0 3 Rotate 160 1 0 0 Shape "disk" "float radius" 2)", {0.2f, 0.1f, 0}},
    {"partOfARing",
     R"(Translate 0 0 3 Rotate 200 1 0 0 Scale 2 1 1 Shape "disk" "float innerradius" 0.5 "float phimax" 290)",
     {0.2f, 0.1f, 0}},
    {"cylinder", R"(Translate 0 0 3 Rotate 70 1 0 0 Shape "cylinder" "float radius" 0.7)", {0.2f, 0.1f, 0}},
    {"partOfACylinder",
     R"("bool twosided" true Translate 0 0 3 Scale 1 2 1 Shape "cylinder" "float zmin" -0.3 "float phimax" 200)",
     {0.2f, 0.1f, 0}},
    {"cylinderFromInside", R"(ReverseOrientation Shape "cylinder" "float zmax" 5)", {0.2f, 0.1f, 0}},
};
INSTANTIATE_TEST_SUITE_P(Shapes, AreaEmitter, ::testing::ValuesIn(kCases), name_of);

/// Lambert's formula for a polygon: irradiance per radiance at a point with the unit `normal`, all corners above it.
double polygon_irradiance(const std::vector<Imath::V3d>& corners, const Imath::V3d& from, const Imath::V3d& normal) {
    double sum = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Imath::V3d a = (corners[i] - from).normalized();
        const Imath::V3d b = (corners[(i + 1) % corners.size()] - from).normalized();
        const Imath::V3d across = a.cross(b);
        sum += 0.5 * std::atan2(across.length(), a.dot(b)) * across.normalized().dot(normal);
    }
    return std::abs(sum);
}

/// However close a point is to the light, one sample is about as good as another: by area, a sample near the point
/// would count (distance to the light)^-2 times as much.
TEST(AreaEmitters, GiveTheIrradianceCloseBy) {
    const std::vector<Imath::V3d> corners = {{-1, -1, 0}, {-1, 1, 0}, {1, 1, 0}, {1, -1, 0}};
    const std::string points[] = {
        R"(Shape "bilinearmesh" "point3 P" [-1 -1 0  -1 1 0  1 -1 0  1 1 0])",
        R"(Shape "trianglemesh" "point3 P" [-1 -1 0  -1 1 0  1 1 0  1 -1 0] "integer indices" [0 1 2 0 2 3])"};
    for (const std::string& shape : points) {
        const PreparedScene scene(parse_world("AreaLightSource \"diffuse\" " + shape), 1);
        for (const float distance : {1e-5f, 1e-3f, 0.1f, 1.0f, 30.0f, 100.0f}) {
            const Imath::V3f from(0.3f, -0.2f, -distance), normal(0.0f, 0.0f, 1.0f);
            Pcg32 random(3);
            Mean irradiance;
            for (int i = 0; i < 20000; ++i) {
                double sum = 0.0;
                for (const Emitter& emitter : scene.emitters()) {
                    const float u = random.next_float();
                    const EmitterSample light = sample(emitter.geometry, from, {u, random.next_float()});
                    if (light.scale == 0.0f) continue;
                    sum += static_cast<double>(light.to_light.dot(normal)) / static_cast<double>(light.pdf);
                }
                irradiance.add(sum);
            }
            const double expected = polygon_irradiance(corners, Imath::V3d(from), Imath::V3d(normal));
            EXPECT_NEAR(irradiance.mean(), expected, 4.5 * irradiance.standard_error() + 1e-5 * expected) << distance;
            // That of cosines uniform in [0, 1] is 1/sqrt(3) of their mean.
            EXPECT_LT(irradiance.standard_error() * std::sqrt(20000.0), 0.6 * expected) << distance;
        }
    }
}

/// Emitters are many: a mesh of 10 million triangles may shine.
TEST(AreaEmitters, AreSmall) { EXPECT_LE(sizeof(Emitter), 80u); }

}  // namespace
}  // namespace emulsion::testing
