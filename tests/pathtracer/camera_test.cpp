#include "pathtracer/camera.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "core/random.h"

namespace emulsion {
namespace {

void expect_direction(const Ray& ray, Imath::V3d expected) {
    expected.normalize();
    EXPECT_NEAR(ray.direction.x, expected.x, 1e-6);
    EXPECT_NEAR(ray.direction.y, expected.y, 1e-6);
    EXPECT_NEAR(ray.direction.z, expected.z, 1e-6);
}

TEST(CameraRays, FieldOfViewSpansTheShorterSide) {
    PerspectiveCamera camera;
    camera.fov_deg = 90.0;
    const CameraRays wide(camera, 200, 100);
    expect_direction(wide.ray(100, 50), {0, 0, 1});
    expect_direction(wide.ray(100, 0), {0, 1, 1});  // the top of the picture is up
    expect_direction(wide.ray(100, 100), {0, -1, 1});
    expect_direction(wide.ray(200, 50), {2, 0, 1});  // and its right is +x
    const CameraRays tall(camera, 100, 200);
    expect_direction(tall.ray(100, 100), {1, 0, 1});
    expect_direction(tall.ray(50, 0), {0, 2, 1});
}

TEST(CameraRays, FollowsTheMatrix) {
    PerspectiveCamera camera;
    camera.fov_deg = 60.0;
    // Imath's row vectors: camera x to world y, y to z, z to x; then moved.
    camera.world_from_camera = Imath::M44d(0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 5, 6, 7, 1);
    const CameraRays rays(camera, 100, 100);
    EXPECT_EQ(rays.ray(10, 20).origin, Imath::V3f(5, 6, 7));
    expect_direction(rays.ray(50, 50), {1, 0, 0});
    expect_direction(rays.ray(100, 50), {1, std::tan(M_PI / 6), 0});
    expect_direction(rays.ray(50, 0), {1, 0, std::tan(M_PI / 6)});
}

TEST(CameraRays, TakesWindowAndAspectFromTheScene) {
    PerspectiveCamera camera;
    camera.fov_deg = 90.0;
    camera.screen.bounds = {{-0.5, 1.0, -0.25, 0.75}};
    const CameraRays windowed(camera, 100, 100);
    expect_direction(windowed.ray(0, 0), {-0.5, 0.75, 1});
    expect_direction(windowed.ray(100, 100), {1.0, -0.25, 1});
    camera.screen.bounds.reset();
    camera.screen.frame_aspect_ratio = 3.0;
    expect_direction(CameraRays(camera, 100, 100).ray(100, 0), {3, 1, 1});
}

// --- Lenses

Imath::V3d at_depth(const Ray& ray, double z) {
    const Imath::V3d origin(ray.origin), direction(ray.direction);
    return origin + direction * ((z - origin.z) / direction.z);
}

void expect_near(const Imath::V3d& found, const Imath::V3d& expected, double tolerance) {
    EXPECT_NEAR((found - expected).length(), 0.0, tolerance) << found << ", expected " << expected;
}

TEST(CameraRays, OnlyLensesWithARadiusCount) {
    PerspectiveCamera camera;
    EXPECT_FALSE(CameraRays(camera, 10, 10).has_lens());
    EXPECT_FALSE(CameraRays(OrthographicCamera{}, 10, 10).has_lens());
    EXPECT_FALSE(CameraRays(SphericalCamera{}, 10, 10).has_lens());
    camera.lens.radius = 0.5;
    const CameraRays rays(camera, 10, 10);
    EXPECT_TRUE(rays.has_lens());
    // The ray through its middle is that of the pinhole.
    camera.lens.radius = 0.0;
    const Ray middle = rays.ray(3, 4), pinhole = CameraRays(camera, 10, 10).ray(3, 4);
    EXPECT_EQ(middle.origin, pinhole.origin);
    expect_near(Imath::V3d(middle.direction), Imath::V3d(pinhole.direction), 1e-7);
}

// A point at depth z through the lens point l is seen where l (1 - z / f) is added to where the pinhole sees it: a
// circle of confusion of radius R |1 - z / f|, and of none on the plane of focus, over the whole picture.
TEST(CameraRays, CirclesOfConfusionGrowFromThePlaneOfFocus) {
    constexpr double kRadius = 0.25, kFocus = 4.0;
    PerspectiveCamera perspective;
    perspective.fov_deg = 60.0;
    OrthographicCamera orthographic;
    perspective.lens = orthographic.lens = {kRadius, kFocus};
    for (const Camera& camera : {Camera(perspective), Camera(orthographic)}) {
        const CameraRays rays(camera, 40, 20);
        Pcg32 random(7);
        double square_sum = 0.0;
        constexpr int kRays = 4096;
        for (int i = 0; i < kRays; ++i) {
            const float x = 40.0f * random.next_float(), y = 20.0f * random.next_float();
            const std::array<float, 2> uv = {random.next_float(), random.next_float()};
            const Ray ray = rays.ray(x, y, uv), middle = rays.ray(x, y);
            const Imath::V3d lens(ray.origin);
            EXPECT_EQ(lens.z, 0.0);
            EXPECT_LE(lens.length(), kRadius * (1.0 + 1e-6));
            square_sum += lens.length2();
            for (const double z : {1.0, kFocus, 10.0}) {
                // Directions are rounded to 2^-24, and seen from up to 10 units away.
                expect_near(
                    at_depth(ray, z) - at_depth(middle, z),
                    lens * (1.0 - z / kFocus) -
                        Imath::V3d(middle.origin) * (std::holds_alternative<OrthographicCamera>(camera) ? 0.0 : 1.0),
                    5e-6);
            }
        }
        // Uniform on the disk: the mean of r^2 is R^2 / 2, its standard deviation R^2 / sqrt(12 n). Five of them.
        EXPECT_NEAR(square_sum / kRays / (kRadius * kRadius), 0.5, 5.0 / std::sqrt(12.0 * kRays));
    }
}

TEST(CameraRays, LensesFollowTheMatrix) {
    PerspectiveCamera camera;
    camera.lens = {0.5, 2.0};
    // Camera x to world y, y to z, z to x, all scaled by 2; then moved.
    camera.world_from_camera = Imath::M44d(0, 2, 0, 0, 0, 0, 2, 0, 2, 0, 0, 0, 5, 6, 7, 1);
    const CameraRays rays(camera, 100, 100);
    const Ray right = rays.ray(50, 50, {1.0f, 0.5f});  // from the rim at x = radius
    expect_near(Imath::V3d(right.origin), {5, 7, 7}, 1e-6);
    expect_direction(right, {4, -1, 0});  // to (5 + 2 * 2, 6, 7)
    const Ray top = rays.ray(50, 50, {0.5f, 1.0f});
    expect_near(Imath::V3d(top.origin), {5, 6, 8}, 1e-6);
    expect_direction(top, {4, 0, -1});
}

// --- Other projections

TEST(CameraRays, OrthographicRaysAreParallel) {
    OrthographicCamera camera;
    const CameraRays wide(camera, 200, 100);
    const std::pair<std::array<float, 2>, Imath::V3d> places[] = {
        {{0, 0}, {-2, 1, 0}}, {{200, 100}, {2, -1, 0}}, {{100, 50}, {0, 0, 0}}, {{150, 50}, {1, 0, 0}}};
    for (const auto& [place, origin] : places) {
        const Ray ray = wide.ray(place[0], place[1]);
        expect_near(Imath::V3d(ray.origin), origin, 1e-6);
        expect_direction(ray, {0, 0, 1});
    }
    camera.screen.bounds = {{0, 10, 0, 5}};
    camera.world_from_camera = Imath::M44d(0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 5, 6, 7, 1);
    const Ray corner = CameraRays(camera, 10, 10).ray(10, 0);
    expect_near(Imath::V3d(corner.origin), {5, 16, 12}, 1e-5);
    expect_direction(corner, {1, 0, 0});
}

TEST(CameraRays, EquirectangularPicturesHaveTheirPolesAboveAndBelow) {
    SphericalCamera camera;
    camera.mapping = SphericalMapping::equirectangular;
    const CameraRays rays(camera, 360, 180);
    for (const float x : {0.0f, 90.0f, 300.0f}) {
        expect_direction(rays.ray(x, 0), {0, 1, 0});
        expect_direction(rays.ray(x, 180), {0, -1, 0});
    }
    expect_direction(rays.ray(0, 90), {1, 0, 0});
    expect_direction(rays.ray(90, 90), {0, 0, 1});
    expect_direction(rays.ray(180, 90), {-1, 0, 0});
    expect_direction(rays.ray(270, 90), {0, 0, -1});
    expect_direction(rays.ray(45, 45), {0.5, std::sqrt(0.5), 0.5});
}

TEST(CameraRays, EqualAreaPicturesShowTheUpperHalfInTheMiddle) {
    const CameraRays rays(SphericalCamera{}, 100, 100);
    expect_direction(rays.ray(50, 50), {0, 1, 0});
    for (const auto& [x, y] : {std::pair(0.0f, 0.0f), {100.0f, 0.0f}, {0.0f, 100.0f}, {100.0f, 100.0f}}) {
        expect_direction(rays.ray(x, y), {0, -1, 0});
    }
    expect_direction(rays.ray(100, 50), {1, 0, 0});
    expect_direction(rays.ray(50, 100), {0, 0, 1});
    expect_direction(rays.ray(0, 50), {-1, 0, 0});
    expect_direction(rays.ray(50, 0), {0, 0, -1});
    // Wide filters reach beyond the picture.
    expect_direction(rays.ray(20, -5), Imath::V3d(rays.ray(80, 5).direction));

    // The picture of N x N pixels sees the same solid angle in each: the mean of f over pixels is that over directions.
    double mean_square_y = 0.0;
    for (int i = 0; i < 100 * 100; ++i) {
        const double y = rays.ray(static_cast<float>(i % 100) + 0.5f, static_cast<float>(i / 100) + 0.5f).direction.y;
        mean_square_y += y * y / 10000.0;
    }
    EXPECT_NEAR(mean_square_y, 1.0 / 3.0, 1e-3);
}

TEST(CameraRays, SphericalCamerasFollowTheMatrix) {
    SphericalCamera camera;
    camera.world_from_camera = Imath::M44d(0, 2, 0, 0, 0, 0, 2, 0, 2, 0, 0, 0, 5, 6, 7, 1);
    const Ray up = CameraRays(camera, 100, 100).ray(50, 50);
    EXPECT_EQ(up.origin, Imath::V3f(5, 6, 7));
    expect_direction(up, {0, 0, 1});
}

TEST(CameraRays, RefusesWhatIsOutOfRange) {
    for (const double wrong : {-1.0, HUGE_VAL, std::nan("")}) {
        PerspectiveCamera blurred;
        blurred.lens.radius = wrong;
        EXPECT_THROW(CameraRays(blurred, 10, 10), std::invalid_argument) << wrong;
        OrthographicCamera focused;
        focused.lens.focal_distance = wrong;
        EXPECT_THROW(CameraRays(focused, 10, 10), std::invalid_argument) << wrong;
        OrthographicCamera narrow;
        narrow.screen.frame_aspect_ratio = wrong;
        EXPECT_THROW(CameraRays(narrow, 10, 10), std::invalid_argument) << wrong;
    }
    PerspectiveCamera camera;
    for (const double fov_deg : {0.0, -1.0, 180.0, std::nan("")}) {
        camera.fov_deg = fov_deg;
        EXPECT_THROW(CameraRays(camera, 10, 10), std::invalid_argument) << fov_deg;
    }
}

}  // namespace
}  // namespace emulsion
