#include "pathtracer/accelerator.h"

#include <cmath>

#include <gtest/gtest.h>

#include "analytic_scenes.h"
#include "core/random.h"
#include "pathtracer/sphere.h"
#include "pathtracer/vector_math.h"

namespace emulsion::testing {
namespace {

TEST(Accelerator, FindsTheFirstHitWithItsCoordinates) {
    Scene scene;
    scene.shapes = {{parallelogram({-1, -1, 3}, {2, 0, 0}, {0, 2, 0}), 0, {}},
                    {parallelogram({-1, -1, 2}, {2, 0, 0}, {0, 2, 0}), 0, {}}};
    const Accelerator accelerator(scene, {}, 1);
    // More rays than any packet is wide, and no multiple of it.
    std::vector<Ray> rays(37, Ray{{0.5f, -0.25f, 0}, {0, 0, 1}});
    rays[20].direction = {0, 0, -1};
    rays[30].origin = {0.5f, -0.25f, 2.5f};
    std::vector<Hit> hits(rays.size());
    accelerator.intersect(rays, hits);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (i == 20) {
            EXPECT_EQ(hits[i].shape, Hit::kNone);
            continue;
        }
        EXPECT_EQ(hits[i].shape, i == 30 ? 0u : 1u);
        EXPECT_FLOAT_EQ(hits[i].t, i == 30 ? 0.5f : 2.0f);
        const auto& mesh = std::get<TriangleMesh>(scene.shapes[hits[i].shape].geometry);
        const auto& corner = mesh.triangle[hits[i].primitive];
        const Imath::V3f p0 = mesh.position[corner[0]], p1 = mesh.position[corner[1]], p2 = mesh.position[corner[2]];
        const Imath::V3f point = p0 + (p1 - p0) * hits[i].u + (p2 - p0) * hits[i].v;
        EXPECT_LT((point - (rays[i].origin + rays[i].direction * hits[i].t)).length(), 1e-5f);
    }

    rays[5].t_max = 1.9f;
    std::vector<std::uint8_t> occluded(rays.size());
    accelerator.occluded(rays, occluded);
    for (std::size_t i = 0; i < rays.size(); ++i) EXPECT_EQ(occluded[i], i == 5 || i == 20 ? 0 : 1) << i;
}

TEST(Accelerator, AnEmptySceneIsHitByNothing) {
    const Scene none;
    const Accelerator accelerator(none, {}, 1);
    const std::vector<Ray> rays(3, Ray{{0, 0, 0}, {0, 0, 1}});
    std::vector<Hit> hits(3);
    accelerator.intersect(rays, hits);
    for (const Hit& hit : hits) EXPECT_EQ(hit.shape, Hit::kNone);
}

TEST(Accelerator, SpheresAndEllipsoidsAreHitWhereTheFormulaSays) {
    Imath::M44d world_from_object;
    world_from_object.setScale(Imath::V3d(2.0, 0.5, 1.0));
    world_from_object.rotate(Imath::V3d(0.3, 0.5, 0.7));
    world_from_object[3][0] = 10.0;
    Scene scene;
    scene.shapes = {{Sphere{world_from_object, 1.5}, 0, {}}};
    const Accelerator accelerator(scene, {}, 1);
    const PreparedSphere sphere(std::get<Sphere>(scene.shapes[0].geometry));
    EXPECT_FALSE(sphere.world_centre.has_value());

    Pcg32 random(3);
    int hit_count = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto number = [&] { return 8.0f * random.next_float() - 4.0f; };
        const float x = number(), y = number(), z = number();
        const Imath::V3f target = Imath::V3f(10, 0, 0) + Imath::V3f(x, y, z) * 0.7f;
        const Ray ray{{0.1f * x, y, z}, target - Imath::V3f(0.1f * x, y, z)};
        Hit hit;
        accelerator.intersect({&ray, 1}, {&hit, 1});
        const auto expected = first_hit(sphere, ray.origin, ray.direction, 0.0, 1e30);
        ASSERT_EQ(hit.shape != Hit::kNone, expected.has_value());
        if (!expected) continue;
        ++hit_count;
        EXPECT_FLOAT_EQ(hit.t, static_cast<float>(*expected));
        // The point lies on the surface: at radius 1.5 of object space.
        Imath::V3d in_object;
        sphere.object_from_world.multVecMatrix(Imath::V3d(ray.origin) + *expected * Imath::V3d(ray.direction),
                                               in_object);
        EXPECT_NEAR(in_object.length(), 1.5, 1e-12 * 20);
    }
    EXPECT_GT(hit_count, 200);
}

/// Rays along z that pass the centre of a sphere of radius r at distance 1, decided to one part in 1e12. In single
/// precision the square of the distance, 16384^2 + 1, would drown it.
TEST(Sphere, GrazingRaysAreDecidedExactly) {
    for (const double radius : {1.0 - 1e-12, 1.0 + 1e-12}) {
        const PreparedSphere sphere(Sphere{{}, radius});
        for (const float z : {-16384.0f, -3.0f}) {
            EXPECT_EQ(first_hit(sphere, {1, 0, z}, {0, 0, 1}, 0.0, 1e9).has_value(), radius > 1.0) << radius;
            EXPECT_EQ(first_hit(sphere, {-1, z, 0}, {0, 4, 0}, 0.0, 1e9).has_value(), radius > 1.0) << radius;
        }
    }
}

TEST(Sphere, NormalsAndStretchFollowTheMap) {
    Imath::M44d world_from_object;
    world_from_object.setScale(Imath::V3d(2.0, 1.0, 1.0));
    PreparedSphere sphere(Sphere{world_from_object, 1.0});
    const QuadricPoint side = point_towards(sphere, {0, 0, 1});
    EXPECT_NEAR(side.normal.z, 1.0, 1e-12);
    EXPECT_NEAR(side.area_stretch, 2.0, 1e-12);
    const QuadricPoint tip = point_towards(sphere, {1, 0, 0});
    EXPECT_NEAR(tip.position.x, 2.0, 1e-12);
    EXPECT_NEAR(tip.area_stretch, 1.0, 1e-12);
    // (x/2)^2 + y^2 = 1 at 45 degrees of object space: the gradient is (x/4, y).
    const QuadricPoint slanted = point_towards(sphere, {1, 1, 0});
    EXPECT_NEAR(slanted.normal.y / slanted.normal.x, 2.0, 1e-12);
    sphere.flip_normal = true;
    EXPECT_NEAR(point_towards(sphere, {0, 0, 1}).normal.z, -1.0, 1e-12);
}

TEST(VectorMath, DiskMapAgreesWithSineAndCosine) {
    Pcg32 random(1);
    for (int i = 0; i < 10000; ++i) {
        const float u = random.next_float();
        const std::array<float, 2> uv{u, random.next_float()};
        const auto [x, y] = uniform_disk(uv);
        const double a = 2.0 * static_cast<double>(uv[0]) - 1.0, b = 2.0 * static_cast<double>(uv[1]) - 1.0;
        const bool wide = std::abs(a) > std::abs(b);
        const double radius = wide ? a : b;
        const double angle = wide ? M_PI / 4 * b / a : M_PI / 2 - M_PI / 4 * a / b;
        EXPECT_NEAR(x, radius * std::cos(angle), 3e-7);
        EXPECT_NEAR(y, radius * std::sin(angle), 3e-7);
    }
    EXPECT_EQ(uniform_disk({0.5f, 0.5f}), (std::array<float, 2>{0.0f, 0.0f}));
}

TEST(VectorMath, FramesAreOrthonormal) {
    Pcg32 random(2);
    for (int i = 0; i < 1000; ++i) {
        const float u = random.next_float();
        Imath::V3f n = uniform_sphere({u, random.next_float()});
        if (i == 0) n = {0, 0, -1};
        const Frame frame(n);
        for (const Imath::V3f& v : {frame.tangent, frame.bitangent}) EXPECT_NEAR(v.length(), 1.0f, 1e-6f);
        EXPECT_NEAR(frame.tangent.dot(frame.bitangent), 0.0f, 1e-6f);
        EXPECT_NEAR((frame.tangent.cross(frame.bitangent) - n).length(), 0.0f, 1e-6f);
    }
}

}  // namespace
}  // namespace emulsion::testing
