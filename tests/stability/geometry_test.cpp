// Rays in single precision: surfaces that meet themselves, and spheres that are just grazed.

#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include "core/random.h"
#include "pathtracer/accelerator.h"
#include "pathtracer/scene.h"
#include "pathtracer/sphere.h"
#include "pathtracer/surface.h"

namespace emulsion {
namespace {

/// A tilted square of this size, at `distance` from the origin.
TriangleMesh tilted_square(float size, float distance) {
    const Imath::V3f corner(0.6f * distance, 0.5f * distance, -0.62f * distance);
    const Imath::V3f a = size * Imath::V3f(0.8f, 0.36f, 0.48f), b = size * Imath::V3f(-0.6f, 0.48f, 0.64f);
    TriangleMesh mesh;
    mesh.position = {corner, corner + a, corner + a + b, corner + b};
    mesh.triangle = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

/// Shares of 20000 rays that leave the square, a tenth of them near its plane, and meet it again, or start further from
/// it than a thousandth of its size: past what lies that close.
struct Shares {
    double self_hits = 0.0, gaps = 0.0;
};

/// `epsilon` < 0: ours.
Shares leave(float size, float distance, float epsilon) {
    Scene scene;
    const TriangleMesh mesh = tilted_square(size, distance);
    scene.materials = {DiffuseMaterial{}};
    scene.shapes = {{mesh, 0, {}}};
    const Accelerator accelerator(scene, {}, 1);
    Pcg32 random(8);
    constexpr int kRays = 20000;
    Shares shares;
    for (int i = 0; i < kRays; ++i) {
        Hit at;
        at.u = random.next_float(), at.v = (1.0f - at.u) * random.next_float();
        at.primitive = random.next() % 2u;
        const SurfacePoint point = surface_point(mesh, at);
        const Imath::V3f along = (mesh.position[1] - mesh.position[0]).normalized();
        const float up = (i % 10 == 0 ? 1e-3f : 1.0f) * random.next_float();
        const Imath::V3f direction = (along * (2.0f * random.next_float() - 1.0f) + point.geometric_normal * up +
                                      point.geometric_normal.cross(along) * (2.0f * random.next_float() - 1.0f))
                                         .normalized();
        const Imath::V3f origin =
            epsilon < 0.0f ? point.origin_towards(direction) : point.position + point.geometric_normal * epsilon;
        const Ray ray{origin, direction};
        Hit hit;
        accelerator.intersect({&ray, 1}, {&hit, 1});
        shares.self_hits += (hit.shape != Hit::kNone ? 1.0 : 0.0) / kRays;
        const float offset = epsilon < 0.0f ? point.offset : epsilon;
        shares.gaps += (offset > 1e-3f * size ? 1.0 : 0.0) / kRays;
    }
    return shares;
}

// An epsilon of 1e-4 is right for rooms of some metres. In a landscape it is less than what rounds off, and in a watch
// it is longer than the teeth of the wheels.
TEST(SelfIntersection, AtEveryScale) {
    constexpr float kEpsilon = 1e-4f, kOurs = -1.0f;
    EXPECT_EQ(leave(1.0f, 10.0f, kEpsilon).self_hits, 0.0);
    EXPECT_NEAR(leave(1e4f, 1e5f, kEpsilon).self_hits, 0.598, 0.01);
    EXPECT_NEAR(leave(1e-4f, 1e-3f, kEpsilon).gaps, 1.0, 1e-9);
    for (const float scale : {1e-4f, 1.0f, 1e4f, 1e8f}) {
        const Shares ours = leave(scale, 10.0f * scale, kOurs);
        EXPECT_EQ(ours.self_hits, 0.0) << scale;
        EXPECT_EQ(ours.gaps, 0.0) << scale;
    }
}

/// The quadratic as textbooks have it, in single precision.
bool meets_unit_sphere(const Imath::V3f& origin, const Imath::V3f& direction) {
    const float a = direction.dot(direction), b = 2.0f * origin.dot(direction), c = origin.dot(origin) - 1.0f;
    return b * b - 4.0f * a * c >= 0.0f;
}

/// Of 20000 rays from this distance that pass the centre of a unit sphere at 1 - graze, the shares that are
/// decided otherwise than exact arithmetic does.
struct Wrong {
    double naive = 0.0, ours = 0.0;
};
Wrong graze(double distance, double graze) {
    const PreparedSphere sphere(Sphere{});
    Pcg32 random(9);
    constexpr int kRays = 20000;
    Wrong wrong;
    for (int i = 0; i < kRays; ++i) {
        const auto number = [&random] { return 2.0f * random.next_float() - 1.0f; };
        const Imath::V3f origin(number(), number(), static_cast<float>(-distance));
        const Imath::V3d to_centre = -Imath::V3d(origin).normalized();
        const Imath::V3d side = to_centre.cross(Imath::V3d(number(), number(), 0.0)).normalized();
        const double sine = (1.0 - graze) / Imath::V3d(origin).length();
        const Imath::V3f direction(to_centre * std::sqrt(1.0 - sine * sine) + side * sine);
        // Of the same single-precision ray: |o x d|^2 <= |d|^2.
        using Real = Imath::Vec3<long double>;
        const Real o(origin.x, origin.y, origin.z), d(direction.x, direction.y, direction.z), cross = o.cross(d);
        const bool exact = cross.dot(cross) <= d.dot(d);
        wrong.naive += (meets_unit_sphere(origin, direction) != exact ? 1.0 : 0.0) / kRays;
        wrong.ours += (first_hit(sphere, origin, direction, 0.0, 1e30).has_value() != exact ? 1.0 : 0.0) / kRays;
    }
    return wrong;
}

TEST(GrazedSphere, IsDecidedInDoublePrecision) {
    EXPECT_NEAR(graze(100.0, 1e-6).naive, 0.158, 0.01);
    // From 10000 radii away, the 1 is lost in the square of the distance: a sphere met by all that passes nearby.
    EXPECT_NEAR(graze(1e4, -1e-4).naive, 1.0, 0.01);
    EXPECT_EQ(graze(100.0, 1e-6).ours, 0.0);
    EXPECT_EQ(graze(1e4, 1e-4).ours, 0.0);
    EXPECT_EQ(graze(1e4, -1e-4).ours, 0.0);
}

}  // namespace
}  // namespace emulsion
