#pragma once
// From a place in the picture to a ray.

#include <array>
#include <variant>

#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

#include "pathtracer/accelerator.h"
#include "pathtracer/scene_camera.h"

namespace emulsion {

/// A camera for one resolution.
class CameraRays {
  public:
    /// \throws std::invalid_argument naming the field, its value and its range: field of view, aspect ratio, lens.
    CameraRays(const Camera& camera, int width_px, int height_px);

    /// Whether rays depend on where they cross the lens.
    [[nodiscard]] bool has_lens() const noexcept;

    /// x_px to the right and y_px downwards from the picture's top left corner. `lens` in [0, 1)^2 is where the ray
    /// crosses the lens, if there is one: uniform there gives uniform on the lens, and (0.5, 0.5) is its middle. The
    /// direction is of unit length.
    [[nodiscard]] Ray ray(float x_px, float y_px, const std::array<float, 2>& lens = {0.5f, 0.5f}) const noexcept;

  private:
    /// Perspective and orthographic cameras: both look at a point that is an affine function of the place.
    struct FlatRays {
        Imath::V3d origin;                      // of camera space
        Imath::V3d corner, per_x_px, per_y_px;  // from there to the places, in world space
        Imath::V3d along;                       // orthographic: what all rays follow; else 0
        // From the middle of the lens to its rim, along x and y; 0: none.
        Imath::V3d lens_x{0.0}, lens_y{0.0};
        double focal_distance = 1.0;
        bool is_parallel = false, has_lens = false;
    };
    struct SphericalRays {
        Imath::M44d world_from_camera;
        SphericalMapping mapping;
        double per_x_px, per_y_px;
    };

    static FlatRays prepare(const PerspectiveCamera& camera, int width_px, int height_px);
    static FlatRays prepare(const OrthographicCamera& camera, int width_px, int height_px);
    static SphericalRays prepare(const SphericalCamera& camera, int width_px, int height_px);
    static FlatRays prepare_flat(const Imath::M44d& world_from_camera, const std::array<double, 4>& window,
                                 const ThinLens& lens, int width_px, int height_px);
    [[nodiscard]] static Ray trace(const FlatRays& rays, float x_px, float y_px,
                                   const std::array<float, 2>& lens) noexcept;
    [[nodiscard]] static Ray trace(const SphericalRays& rays, float x_px, float y_px) noexcept;

    std::variant<FlatRays, SphericalRays> rays_;
};

}  // namespace emulsion
