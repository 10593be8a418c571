#pragma once
// What the albedo layer shows of materials.

#include <array>
#include <optional>
#include <vector>

#include "pathtracer/prepared_textures.h"
#include "pathtracer/scene.h"
#include "spectrum/reflectance_weights.h"

namespace emulsion {

/// Linear Rec. 709 RGB of the share of light that a material gives back under D65, whichever way: of metals that at
/// normal incidence, of glass all, of coats that of what lies below.
class MaterialAlbedos {
  public:
    /// `scene` must outlive this.
    explicit MaterialAlbedos(const Scene& scene);

    /// Of Scene::materials[material] at a point, which only materials with textures look at.
    [[nodiscard]] std::array<float, 3> operator()(int material, const TexturePoint& point) const;

  private:
    class AlbedoOf;
    /// Tells whether a texture had a say in it.
    [[nodiscard]] std::array<float, 3> at(int material, const TexturePoint& point, bool& textured) const;

    const Scene& scene_;
    ReflectanceRgb rgb_;
    SpectrumTables spectra_;  // of the textures
    PreparedTextures textures_;
    std::vector<std::optional<std::array<float, 3>>> constant_;  // of each material; none: it has textures
};

}  // namespace emulsion
