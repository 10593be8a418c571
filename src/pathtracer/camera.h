#pragma once
// From a place in the picture to a ray.

#include <Imath/ImathVec.h>

#include "pathtracer/accelerator.h"
#include "pathtracer/scene.h"

namespace emulsion {

/// The pinhole camera for one resolution: the direction is an affine function of the place in the picture.
class CameraRays {
  public:
    /// \throws std::invalid_argument if the field of view or the aspect ratio is out of range.
    CameraRays(const PerspectiveCamera& camera, int width_px, int height_px);

    /// x_px to the right and y_px downwards from the picture's top left corner. The direction is of unit length.
    [[nodiscard]] Ray ray(float x_px, float y_px) const noexcept;

  private:
    Imath::V3f origin_;
    Imath::V3d corner_, per_x_px_, per_y_px_;  // directions in world space, before normalising
};

}  // namespace emulsion
