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
#include "film/film_tile.h"
#include "pathtracer/accelerator.h"
#include "pathtracer/material_albedo.h"
#include "pathtracer/prepared_scene.h"
#include "pathtracer/scene.h"

namespace emulsion {

/// What a path meets first.
struct FirstHit {
    std::uint32_t shape = Hit::kNone;  ///< index into Scene::shapes, or Hit::kNone: nothing
    float distance = 0.0f;             ///< along the ray, in lengths of its direction
    Imath::V3f facing_normal{0.0f};    ///< unit, world space; on the side from which the ray comes
    TexturePoint place;                ///< if the scene has textures
};

/// The first hits of camera rays; all spans of one size.
void note_first_hits(const PreparedScene& scene, std::span<const Ray> rays, std::span<const Hit> hits,
                     std::span<FirstHit> first_hits) noexcept;

/// The layers of one film, for one scene.
class AuxLayers {
  public:
    /// `scene` must outlive this.
    /// \throws std::invalid_argument unless all layers are known_aux_layers().
    AuxLayers(const Scene& scene, const std::vector<AuxLayer>& layers);

    [[nodiscard]] bool empty() const noexcept { return !albedo_layer_ && !normal_layer_ && !depth_layer_; }

    /// Adds what a path has met first, if it is anything: to a pixel, or around a place for films that splat.
    void add(FilmTile& tile, int x, int y, float weight, const FirstHit& hit) const noexcept;
    void add_at(FilmTile& tile, float x_px, float y_px, const FirstHit& hit) const noexcept;

  private:
    /// Calls add(layer, values).
    template <class Add>
    void for_each(const FirstHit& hit, const Add& add) const noexcept;

    const Scene& scene_;
    std::optional<std::size_t> albedo_layer_, normal_layer_, depth_layer_;
    std::optional<MaterialAlbedos> albedos_;  // if there is such a layer
};

}  // namespace emulsion
