#include "pathtracer/texture_point.h"

#include "pathtracer/prepared_scene.h"
#include "pathtracer/surface_coordinates.h"

namespace emulsion {

TexturePoint texture_point(const PreparedScene& scene, const Hit& hit, const SurfacePoint& point) noexcept {
    return {point.position, surface_uv(scene, hit, point)};
}

}  // namespace emulsion
