#pragma once
// Cameras as a scene describes them. Camera space is left-handed: x to the right, y up, looking along +z.

#include <array>
#include <optional>
#include <variant>

#include <Imath/ImathMatrix.h>

namespace emulsion {

/// Which part of the plane z = 1 the picture shows, beside the resolution.
struct ScreenWindow {
    /// x min, x max, y min, y max; unset: the shorter side spans [-1, 1].
    std::optional<std::array<double, 4>> bounds;
    std::optional<double> frame_aspect_ratio;  ///< width / height; unset: that of the resolution
};

/// A thin lens; everything is sharp with radius 0.
struct ThinLens {
    double radius = 0.0;          ///< >= 0
    double focal_distance = 1e6;  ///< from the lens to the plane that is sharp, along z; > 0
};

struct PerspectiveCamera {
    Imath::M44d world_from_camera;  ///< Imath's convention: row vectors, p * M
    double fov_deg = 90.0;          ///< full angle along the shorter side of the picture; in (0, 180)
    ScreenWindow screen;            ///< in units of tan(fov/2)
    ThinLens lens;
};

/// Parallel rays along +z.
struct OrthographicCamera {
    Imath::M44d world_from_camera;
    ScreenWindow screen;  ///< in units of length
    ThinLens lens;
};

enum class SphericalMapping {
    equal_area,       ///< Clarberg's octahedral square: every pixel sees the same solid angle
    equirectangular,  ///< longitude along x, latitude along y
};

/// Sees in all directions from the origin. With equal areas the middle of the picture is up (y), its corners are all
/// down, and its right, lower, left and upper edges have their middles at x, z, -x and -z. Equirectangular pictures
/// have up in the top row, and from left to right x, z, -x, -z and x again.
struct SphericalCamera {
    Imath::M44d world_from_camera;
    SphericalMapping mapping = SphericalMapping::equal_area;
};

using Camera = std::variant<PerspectiveCamera, OrthographicCamera, SphericalCamera>;

}  // namespace emulsion
