#include "pathtracer/camera.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/visit.h"
#include "pathtracer/equal_area.h"
#include "pathtracer/scene_transform.h"

namespace emulsion {

namespace {

constexpr double kPi = std::numbers::pi;

[[noreturn]] void refuse(const std::string& field, double value, const std::string& range) {
    throw std::invalid_argument(field + " " + std::to_string(value) + ": must " + range);
}

/// x min, x max, y min, y max: the shorter side spans [-1, 1] unless the camera says otherwise.
std::array<double, 4> bounds_of(const ScreenWindow& screen, int width_px, int height_px) {
    if (screen.bounds) return *screen.bounds;
    const double aspect = screen.frame_aspect_ratio.value_or(static_cast<double>(width_px) / height_px);
    if (!(aspect > 0.0) || !std::isfinite(aspect)) refuse("frame_aspect_ratio", aspect, "be finite and above 0");
    if (aspect > 1.0) return {-aspect, aspect, -1.0, 1.0};
    return {-1.0, 1.0, -1.0 / aspect, 1.0 / aspect};
}

/// Uniform in [0, 1)^2 to uniform on the unit disk.
/// Source: P. Shirley & K. Chiu, "A Low Distortion Map Between Disk and Square", Journal of Graphics Tools 2(3), 1997.
Imath::V2d on_disk(const std::array<float, 2>& uv) noexcept {
    const double x = 2.0 * static_cast<double>(uv[0]) - 1.0, y = 2.0 * static_cast<double>(uv[1]) - 1.0;
    if (x == 0.0 && y == 0.0) return Imath::V2d(0.0);
    const bool wide = std::abs(x) > std::abs(y);
    const double radius = wide ? x : y;
    const double phi = wide ? 0.25 * kPi * (y / x) : 0.5 * kPi - 0.25 * kPi * (x / y);
    return {radius * std::cos(phi), radius * std::sin(phi)};
}

Ray unit_ray(const Imath::V3d& origin, const Imath::V3d& direction) noexcept {
    return {Imath::V3f(origin), Imath::V3f(direction * (1.0 / std::sqrt(direction.dot(direction))))};
}

/// In camera space: y up.
Imath::V3d spherical_direction(SphericalMapping mapping, const Imath::V2d& place) noexcept {
    if (mapping == SphericalMapping::equal_area) {
        const Imath::V3d direction = equal_area_direction(wrapped_equal_area_place(place));
        return {direction.x, direction.z, direction.y};
    }
    const double theta = kPi * place.y, phi = 2.0 * kPi * place.x;
    return {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
}

}  // namespace

CameraRays::FlatRays CameraRays::prepare_flat(const Imath::M44d& world_from_camera, const std::array<double, 4>& window,
                                              const ThinLens& lens, int width_px, int height_px) {
    if (!(lens.radius >= 0.0) || !std::isfinite(lens.radius)) refuse("lens radius", lens.radius, "be finite and >= 0");
    if (!(lens.focal_distance > 0.0) || !std::isfinite(lens.focal_distance)) {
        refuse("focal_distance", lens.focal_distance, "be finite and above 0");
    }
    const auto to_world = [&](const Imath::V3d& v) { return transform_vector(world_from_camera, v); };
    // Rows run downwards, y upwards.
    const auto [x_min, x_max, y_min, y_max] = window;
    FlatRays rays;
    rays.origin = world_from_camera.translation();
    rays.corner = to_world({x_min, y_max, 0.0});
    rays.per_x_px = to_world({(x_max - x_min) / width_px, 0.0, 0.0});
    rays.per_y_px = to_world({0.0, (y_min - y_max) / height_px, 0.0});
    rays.along = to_world({0.0, 0.0, 1.0});
    rays.lens_x = to_world({lens.radius, 0.0, 0.0});
    rays.lens_y = to_world({0.0, lens.radius, 0.0});
    rays.focal_distance = lens.focal_distance;
    rays.has_lens = lens.radius > 0.0;
    return rays;
}

CameraRays::FlatRays CameraRays::prepare(const PerspectiveCamera& camera, int width_px, int height_px) {
    if (!(camera.fov_deg > 0.0 && camera.fov_deg < 180.0)) refuse("fov_deg", camera.fov_deg, "lie in (0, 180)");
    // The picture on the plane z = 1.
    std::array<double, 4> window = bounds_of(camera.screen, width_px, height_px);
    for (double& bound : window) bound *= std::tan(0.5 * camera.fov_deg * kPi / 180.0);
    FlatRays rays = prepare_flat(camera.world_from_camera, window, camera.lens, width_px, height_px);
    rays.corner += rays.along;
    return rays;
}

CameraRays::FlatRays CameraRays::prepare(const OrthographicCamera& camera, int width_px, int height_px) {
    FlatRays rays = prepare_flat(camera.world_from_camera, bounds_of(camera.screen, width_px, height_px), camera.lens,
                                 width_px, height_px);
    rays.is_parallel = true;
    return rays;
}

CameraRays::SphericalRays CameraRays::prepare(const SphericalCamera& camera, int width_px, int height_px) {
    return {camera.world_from_camera, camera.mapping, 1.0 / width_px, 1.0 / height_px};
}

CameraRays::CameraRays(const Camera& camera, int width_px, int height_px)
    : rays_(std::visit([&](const auto& c) { return decltype(rays_)(prepare(c, width_px, height_px)); }, camera)) {}

bool CameraRays::has_lens() const noexcept {
    const auto* const flat = std::get_if<FlatRays>(&rays_);
    return flat != nullptr && flat->has_lens;
}

Ray CameraRays::ray(float x_px, float y_px, const std::array<float, 2>& lens) const noexcept {
    if (const auto* const flat = std::get_if<FlatRays>(&rays_)) return trace(*flat, x_px, y_px, lens);
    return trace(*std::get_if<SphericalRays>(&rays_), x_px, y_px);
}

Ray CameraRays::trace(const FlatRays& rays, float x_px, float y_px, const std::array<float, 2>& lens) noexcept {
    const Imath::V3d place =
        rays.corner + static_cast<double>(x_px) * rays.per_x_px + static_cast<double>(y_px) * rays.per_y_px;
    if (!rays.has_lens) {
        return rays.is_parallel ? unit_ray(rays.origin + place, rays.along) : unit_ray(rays.origin, place);
    }
    // Through one point of the lens to the point that is sharp, where the ray through the middle of a pinhole would
    // cross the plane of focus.
    const Imath::V2d at = on_disk(lens);
    const Imath::V3d from_middle = at.x * rays.lens_x + at.y * rays.lens_y;
    const Imath::V3d sharp = rays.is_parallel ? place + rays.focal_distance * rays.along : rays.focal_distance * place;
    return unit_ray(rays.origin + from_middle, sharp - from_middle);
}

Ray CameraRays::trace(const SphericalRays& rays, float x_px, float y_px) noexcept {
    const Imath::V2d place(static_cast<double>(x_px) * rays.per_x_px, static_cast<double>(y_px) * rays.per_y_px);
    return unit_ray(rays.world_from_camera.translation(),
                    transform_vector(rays.world_from_camera, spherical_direction(rays.mapping, place)));
}

}  // namespace emulsion
