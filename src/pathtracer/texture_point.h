#pragma once

#include <Imath/ImathVec.h>

#include "pathtracer/accelerator.h"
#include "pathtracer/surface.h"

namespace emulsion {

class PreparedScene;

/// Where textures are looked up.
struct TexturePoint {
    Imath::V3f position{0.0f};  ///< world space
    Imath::V2f uv{0.0f};        ///< the surface's own parameters
};

/// That of a hit, of which `point` is the surface_point(). To be asked for where there are textures only.
[[nodiscard]] TexturePoint texture_point(const PreparedScene& scene, const Hit& hit,
                                         const SurfacePoint& point) noexcept;

}  // namespace emulsion
