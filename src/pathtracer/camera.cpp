#include "pathtracer/camera.h"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace emulsion {

namespace {

/// x min, x max, y min, y max: the shorter side spans [-1, 1] unless the camera says otherwise.
std::array<double, 4> screen_window(const PerspectiveCamera& camera, int width_px, int height_px) {
    if (camera.screen.bounds) return *camera.screen.bounds;
    const double aspect = camera.screen.frame_aspect_ratio.value_or(static_cast<double>(width_px) / height_px);
    if (!(aspect > 0.0) || !std::isfinite(aspect)) {
        throw std::invalid_argument("frame_aspect_ratio " + std::to_string(aspect) + ": must be finite and above 0");
    }
    if (aspect > 1.0) return {-aspect, aspect, -1.0, 1.0};
    return {-1.0, 1.0, -1.0 / aspect, 1.0 / aspect};
}

}  // namespace

CameraRays::CameraRays(const PerspectiveCamera& camera, int width_px, int height_px)
    : origin_(Imath::V3f(camera.world_from_camera.translation())) {
    if (!(camera.fov_deg > 0.0 && camera.fov_deg < 180.0)) {
        throw std::invalid_argument("fov_deg " + std::to_string(camera.fov_deg) + ": must lie in (0, 180)");
    }
    const double half_extent = std::tan(0.5 * camera.fov_deg * std::numbers::pi / 180.0);
    const auto [x_min, x_max, y_min, y_max] = screen_window(camera, width_px, height_px);

    // In camera space the picture lies on z = 1, y up, and rows run downwards.
    const auto to_world = [&](const Imath::V3d& direction) {
        Imath::V3d world;
        camera.world_from_camera.multDirMatrix(direction, world);
        return world;
    };
    corner_ = to_world({x_min * half_extent, y_max * half_extent, 1.0});
    per_x_px_ = to_world({(x_max - x_min) * half_extent / width_px, 0.0, 0.0});
    per_y_px_ = to_world({0.0, (y_min - y_max) * half_extent / height_px, 0.0});
}

Ray CameraRays::ray(float x_px, float y_px) const noexcept {
    const Imath::V3d direction =
        corner_ + static_cast<double>(x_px) * per_x_px_ + static_cast<double>(y_px) * per_y_px_;
    return {origin_, Imath::V3f(direction * (1.0 / std::sqrt(direction.dot(direction))))};
}

}  // namespace emulsion
