#pragma once
// Materials made ready for shading: spectra by index, constants apart from textures.

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "pathtracer/bsdf_variant.h"
#include "pathtracer/scene_material.h"
#include "pathtracer/spectrum_tables.h"
#include "pathtracer/transport.h"

namespace emulsion {

/// A reflectance: a table of the scene's.
struct PreparedReflectance {
    std::uint32_t table = 0;
};
struct PreparedNumber {
    float constant = 0.0f;
};
struct PreparedRoughness {
    PreparedNumber u, v;
    bool remap = true;
};

struct PreparedDiffuse {
    PreparedReflectance reflectance;
};
struct PreparedConductor {
    std::optional<PreparedReflectance> reflectance;  ///< at normal incidence; or else
    std::uint32_t eta = 0, k = 0;                    ///< tables
    PreparedRoughness roughness;
};
struct PreparedDielectric {
    std::uint32_t eta = 0;
    bool disperses = false;  ///< eta is not constant
    PreparedRoughness roughness;
};
struct PreparedThinDielectric {
    std::uint32_t eta = 0;
};
struct PreparedDiffuseTransmission {
    PreparedReflectance reflectance, transmittance;
    float scale = 1.0f;
};
struct PreparedCoatedDiffuse {
    PreparedReflectance reflectance;
    std::uint32_t eta = 0;
    bool disperses = false;
    std::uint32_t internal_reflectance = 0;  ///< table of coat_internal_reflectance
    PreparedRoughness roughness;
    float thickness = 0.0f;
    int terms = 0;
};
struct PreparedMix {
    std::uint32_t first = 0, second = 0;
    PreparedNumber amount;
};

using PreparedMaterial = std::variant<PreparedDiffuse, PreparedConductor, PreparedDielectric, PreparedThinDielectric,
                                      PreparedDiffuseTransmission, PreparedCoatedDiffuse, PreparedMix>;

class PreparedMaterials {
  public:
    /// Adds the materials' spectra to `spectra`, and keeps a reference to it.
    /// \throws std::invalid_argument naming what is out of range; for a mix that contains itself.
    PreparedMaterials(const std::vector<Material>& materials, SpectrumTables& spectra);

    [[nodiscard]] const PreparedMaterial& operator[](std::uint32_t i) const noexcept { return materials_[i]; }

    /// The table of a Lambertian reflectance that is the same everywhere; unset for every other material.
    /// \throws std::out_of_range if there is no such material.
    [[nodiscard]] std::optional<std::uint32_t> constant_diffuse(std::uint32_t i) const;

    /// The material that a surface of material `i` shows, through mixes: drawn by `next_u`, uniform in [0, 1).
    template <class Source>
    [[nodiscard]] const PreparedMaterial& at(std::uint32_t i, Source&& next_u) const noexcept {
        const PreparedMaterial* material = &materials_[i];
        while (const auto* mix = std::get_if<PreparedMix>(material)) {
            material = &materials_[next_u() < mix->amount.constant ? mix->second : mix->first];
        }
        return *material;
    }

    /// How a material that is neither diffuse nor a mix scatters, for the path's channels. `seed` decides what a rough
    /// coat's estimates are.
    template <class Transport>
    [[nodiscard]] Bsdf<Transport::kChannels> bsdf(const PreparedMaterial& material,
                                                  const typename Transport::Index& index, Channels channels,
                                                  std::uint64_t seed) const noexcept;

    /// Whether bsdf() of this material holds for the first channel alone, whatever direction is drawn.
    [[nodiscard]] bool needs_one_channel(const PreparedMaterial& material) const noexcept;
    /// Whether it uses the seed.
    [[nodiscard]] bool is_estimated(const PreparedMaterial& material) const noexcept {
        return std::holds_alternative<PreparedCoatedDiffuse>(material);
    }

  private:
    const SpectrumTables& spectra_;
    std::vector<PreparedMaterial> materials_;
};

}  // namespace emulsion
