#include "pathtracer/scene_cameras.h"

#include <array>
#include <string>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene_text.h"

namespace emulsion {
namespace {

using testing::parse_options;
using testing::perspective;

TEST(SceneCameras, Camera) {
    const Scene scene = parse_options(R"(Camera "perspective" "float fov" 39.5 "float frameaspectratio" [ 1.5 ]
        "float screenwindow" [ -1 2 -3 4 ] "float lensradius" 0.25 "float focaldistance" 12)");
    EXPECT_EQ(perspective(scene).fov_deg, 39.5);
    EXPECT_EQ(perspective(scene).screen.frame_aspect_ratio, 1.5);
    EXPECT_EQ(perspective(scene).screen.bounds, (std::array<double, 4>{-1, 2, -3, 4}));
    EXPECT_EQ(perspective(scene).lens.radius, 0.25);
    EXPECT_EQ(perspective(scene).lens.focal_distance, 12.0);

    const Scene parallel = parse_options(R"(Translate 0 0 -3 Camera "orthographic" "float lensradius" 2
        "float screenwindow" [ -1 2 -3 4 ] "float frameaspectratio" 2)");
    const auto& orthographic = std::get<OrthographicCamera>(parallel.camera);
    EXPECT_EQ(orthographic.world_from_camera.translation() + parallel.origin, Imath::V3d(0, 0, 3));
    EXPECT_EQ(orthographic.screen.bounds, (std::array<double, 4>{-1, 2, -3, 4}));
    EXPECT_EQ(orthographic.screen.frame_aspect_ratio, 2.0);
    EXPECT_EQ(orthographic.lens.radius, 2.0);
    EXPECT_EQ(orthographic.lens.focal_distance, 1e6);

    const auto mapping = [](const std::string& parameters) {
        return std::get<SphericalCamera>(parse_options("Camera \"spherical\" " + parameters).camera).mapping;
    };
    EXPECT_EQ(mapping(""), SphericalMapping::equal_area);
    EXPECT_EQ(mapping(R"("string mapping" "equalarea" "float lensradius" 1)"), SphericalMapping::equal_area);
    EXPECT_EQ(mapping(R"("string mapping" "equirectangular")"), SphericalMapping::equirectangular);
}

TEST(SceneCameras, AShutterThatClosesFirstIsTakenTheOtherWayRoundAsInPbrt) {
    const Scene scene = parse_options(R"(Camera "perspective" "float shutteropen" 2 "float shutterclose" 1.75)");
    EXPECT_EQ(scene.film.sensor.exposure_time_s, 0.25);
    EXPECT_THAT(scene.warnings,
                ::testing::Contains("t.pbrt:1:8: the shutter closes before it opens: taken the other way "
                                    "round"));
}

// The camera's time also reaches a film that is described before it or not at all.
TEST(SceneCameras, ExposureTimeIsTheCameras) {
    const std::string camera = R"(Camera "perspective" "float shutterclose" 0.125 )";
    EXPECT_EQ(parse_options(camera).film.sensor, SensorOptions{.exposure_time_s = 0.125});
    EXPECT_EQ(parse_options(R"(Film "rgb" "float iso" 200 )" + camera).film.sensor,
              (SensorOptions{.exposure_time_s = 0.125, .iso = 200.0}));
}

}  // namespace
}  // namespace emulsion
