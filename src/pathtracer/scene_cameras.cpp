#include "pathtracer/scene_cameras.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "pathtracer/scene_options.h"
#include "pathtracer/scene_transform.h"

namespace emulsion {

namespace {

Imath::M44d read_world_from_camera(const ParameterList& list, const Imath::M44d& camera_from_world) {
    const std::optional<Imath::M44d> inverse = inverse_of(camera_from_world);
    if (!inverse) throw SceneError(list.place, "a camera under a transformation without inverse", "another one");
    const Imath::V3d position = inverse->translation();
    if (is_within_reach(position)) return *inverse;
    throw SceneError(list.place, fmt::format("a camera at ({:g}, {:g}, {:g})", position.x, position.y, position.z),
                     std::string(kWithinReach));
}

/// \throws SceneError if a point of camera space whose coordinates are this large may lie beyond reach in world space,
/// or one of world space in camera space.
void check_camera_reach(const ParameterList& list, const Imath::M44d& world_from_camera, double extent) {
    const auto& m = world_from_camera.x;
    double stretch = 0.0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) stretch = std::max(stretch, std::abs(m[i][j]));
    }
    if (stretch * std::max(extent, 1.0) <= kReach && stretch * kReach >= 1.0) return;
    throw SceneError(list.place, fmt::format("a camera that reaches {:g} units, each {:g} long", extent, stretch),
                     std::string(kWithinReach));
}

double largest_extent(const ScreenWindow& screen, const ThinLens& lens) noexcept {
    double extent = std::max(lens.radius, 1.0);
    for (const double bound : screen.bounds.value_or(std::array<double, 4>{}))
        extent = std::max(extent, std::abs(bound));
    return extent;
}

ScreenWindow read_screen_window(const ParameterList& list) {
    ScreenWindow screen;
    if (find_parameter(list, "frameaspectratio") != nullptr) {
        screen.frame_aspect_ratio = real_or(list, "frameaspectratio", 1.0);
    }
    const SceneParameter* const window = find_parameter(list, "screenwindow");
    if (window == nullptr) return screen;
    auto& values = screen.bounds.emplace();
    std::copy_n(window->numbers.begin(), values.size(), values.begin());
    if (values[0] == values[1] || values[2] == values[3]) {
        throw SceneError(window->first_value, "a screen window without area", "x min, x max, y min, y max");
    }
    return screen;
}

ThinLens read_lens(const ParameterList& list) {
    ThinLens lens;
    lens.radius = real_or(list, "lensradius", lens.radius);
    lens.focal_distance = real_or(list, "focaldistance", lens.focal_distance);
    return lens;
}

Camera read_perspective(const ParameterList& list, const Imath::M44d& world_from_camera) {
    PerspectiveCamera camera;
    camera.world_from_camera = world_from_camera;
    camera.fov_deg = real_or(list, "fov", camera.fov_deg);
    if (!(camera.fov_deg < 180.0)) {
        throw SceneError(find_parameter(list, "fov")->first_value, fmt::format("a field of view of {}", camera.fov_deg),
                         "an angle above 0 and below 180 degrees");
    }
    camera.screen = read_screen_window(list);
    camera.lens = read_lens(list);
    check_camera_reach(list, world_from_camera, largest_extent(camera.screen, camera.lens));
    return camera;
}

Camera read_orthographic(const ParameterList& list, const Imath::M44d& world_from_camera) {
    const OrthographicCamera camera{world_from_camera, read_screen_window(list), read_lens(list)};
    check_camera_reach(list, world_from_camera, largest_extent(camera.screen, camera.lens));
    return camera;
}

Camera read_spherical(const ParameterList& list, const Imath::M44d& world_from_camera) {
    check_camera_reach(list, world_from_camera, 1.0);
    const bool equal_area = string_or(list, "mapping", "equalarea") == "equalarea";
    return SphericalCamera{world_from_camera,
                           equal_area ? SphericalMapping::equal_area : SphericalMapping::equirectangular};
}

struct CameraReader {
    std::string_view name;
    Camera (*read)(const ParameterList&, const Imath::M44d& world_from_camera);
};
constexpr auto kReaders = std::to_array<CameraReader>(
    {{"perspective", read_perspective}, {"orthographic", read_orthographic}, {"spherical", read_spherical}});

}  // namespace

Camera read_camera(const ParameterList& list, const Imath::M44d& camera_from_world, double& exposure_time_s,
                   SceneWarnings& warnings) {
    check_parameters(camera_table(), list);
    const double time_s = real_or(list, "shutterclose", 1.0) - real_or(list, "shutteropen", 0.0);
    if (time_s < 0.0) warnings.add(list.place, "the shutter closes before it opens: taken the other way round");
    exposure_time_s =
        checked_exposure(list.place, std::abs(time_s), "an exposure time of", R"("shutterclose" after "shutteropen")");
    return supported_row<CameraReader>(list.place, {"camera"}, list.owner, kReaders)
        .read(list, read_world_from_camera(list, camera_from_world));
}

}  // namespace emulsion
