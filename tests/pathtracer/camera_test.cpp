#include "pathtracer/camera.h"

#include <cmath>

#include <gtest/gtest.h>

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

TEST(CameraRays, RefusesWhatIsOutOfRange) {
    PerspectiveCamera camera;
    for (const double fov_deg : {0.0, -1.0, 180.0, std::nan("")}) {
        camera.fov_deg = fov_deg;
        EXPECT_THROW(CameraRays(camera, 10, 10), std::invalid_argument) << fov_deg;
    }
}

}  // namespace
}  // namespace emulsion
