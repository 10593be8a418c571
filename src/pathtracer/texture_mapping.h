#pragma once
// From points of surfaces to points of textures.

#include <Imath/ImathVec.h>

#include "pathtracer/scene_texture.h"
#include "pathtracer/texture_point.h"

namespace emulsion {

/// (s, t) of a point: see the mappings. Finite, unless scales overflow. No ray differentials come with it, as there are
/// no filters here that would need them.
[[nodiscard]] Imath::V2d map(const TextureMapping& mapping, const TexturePoint& point) noexcept;
/// The point of texture space.
[[nodiscard]] Imath::V3d map(const SolidTextureMapping& mapping, const TexturePoint& point) noexcept;

}  // namespace emulsion
