#pragma once
// What the film's auxiliary layers show, of the first surface that a camera ray meets:
//
//     albedo  linear Rec. 709 RGB of the material's reflectance under D65, the perfect reflector being (1, 1, 1):
//             exact, not from the path's wavelengths, and so without noise of its own. A component may leave [0, 1] for
//             a reflectance outside Rec. 709. A lamp's is that of its surface, whatever it emits.
//     normal  the shading normal in world space, on the side from which the ray comes; a mean of unit vectors, and so
//             shorter where a pixel sees several
//     depth   the distance along the ray, in scene units
//
// Rays that meet nothing leave them out: a pixel's value is the mean over those that do, and 0 if none does.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Imath/ImathVec.h>

#include "film/film_options.h"
#include "pathtracer/accelerator.h"
#include "pathtracer/scene.h"

namespace emulsion {

/// What a path meets first.
struct FirstHit {
    std::uint32_t shape = Hit::kNone;  ///< index into Scene::shapes, or Hit::kNone: nothing
    float distance = 0.0f;             ///< along the ray, in lengths of its direction
    Imath::V3f facing_normal{0.0f};    ///< unit, world space; on the side from which the ray comes
};

/// The layers of one film, for one scene.
class AuxLayers {
  public:
    /// `scene` must outlive this.
    /// \throws std::invalid_argument unless all layers are known_aux_layers().
    AuxLayers(const Scene& scene, const std::vector<AuxLayer>& layers);

    [[nodiscard]] bool empty() const noexcept { return !albedo_layer_ && !normal_layer_ && !depth_layer_; }

    /// add(layer, values) for each layer, if something was met.
    template <class Add>
    void for_each(const FirstHit& hit, const Add& add) const noexcept {
        if (hit.shape == Hit::kNone) return;
        if (albedo_layer_) {
            const auto material = static_cast<std::size_t>(scene_.shapes[hit.shape].material);
            add(*albedo_layer_, std::span<const float>(material_albedo_[material]));
        }
        if (normal_layer_) {
            const std::array<float, 3> normal = {hit.facing_normal.x, hit.facing_normal.y, hit.facing_normal.z};
            add(*normal_layer_, std::span<const float>(normal));
        }
        if (depth_layer_) add(*depth_layer_, std::span<const float>(&hit.distance, 1));
    }

  private:
    const Scene& scene_;
    std::optional<std::size_t> albedo_layer_, normal_layer_, depth_layer_;
    std::vector<std::array<float, 3>> material_albedo_;  // if there is such a layer
};

}  // namespace emulsion
