#pragma once

#include <Imath/ImathVec.h>

namespace emulsion {

/// Where textures are looked up.
struct TexturePoint {
    Imath::V3f position{0.0f};  ///< world space
    Imath::V2f uv{0.0f};        ///< the surface's own parameters
};

}  // namespace emulsion
