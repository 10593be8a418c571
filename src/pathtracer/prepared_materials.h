#pragma once
// Materials made ready for shading: spectra by index, constants apart from textures.

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "pathtracer/bsdf_variant.h"
#include "pathtracer/prepared_textures.h"
#include "pathtracer/scene.h"
#include "pathtracer/spectrum_tables.h"
#include "pathtracer/transport.h"

namespace emulsion {

/// A table of the scene's spectra, or the texture.
struct PreparedReflectance {
    std::uint32_t table = 0;
    std::int32_t texture = -1;  ///< none
};
struct PreparedNumber {
    float constant = 0.0f;
    std::int32_t texture = -1;  ///< none
};
struct PreparedRoughness {
    PreparedNumber u, v;
    bool remap = true;
    bool anisotropic = false;  ///< u and v may differ
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
    /// Adds the spectra of materials and textures to `spectra`, and keeps a reference to it.
    /// \throws std::invalid_argument naming what is out of range; for a mix that contains itself.
    PreparedMaterials(const Scene& scene, SpectrumTables& spectra);

    /// As PreparedTextures::prepare().
    void prepare(const FixedChannels& channels) { textures_.prepare(channels); }

    [[nodiscard]] const PreparedMaterial& operator[](std::uint32_t i) const noexcept { return materials_[i]; }

    /// The table of a Lambertian reflectance that is the same everywhere; unset for every other material.
    /// \throws std::out_of_range if there is no such material.
    [[nodiscard]] std::optional<std::uint32_t> constant_diffuse(std::uint32_t i) const;

    /// The material that a surface of material `i` shows at a point, through mixes: drawn by `next_u`, uniform in
    /// [0, 1). pbrt-v4 makes the numbers of the point itself, and so has the same mean.
    template <class Source>
    [[nodiscard]] const PreparedMaterial& at(std::uint32_t i, const TexturePoint& point,
                                             Source&& next_u) const noexcept {
        const PreparedMaterial* material = &materials_[i];
        while (const auto* mix = std::get_if<PreparedMix>(material)) {
            material = &materials_[next_u() < number(mix->amount, point) ? mix->second : mix->first];
        }
        return *material;
    }

    /// Of a diffuse material.
    template <class Index>
    [[nodiscard]] ValuesAt<Index> reflectance(const PreparedDiffuse& diffuse, const TexturePoint& point,
                                              const Index& index) const noexcept {
        const auto& [table, texture] = diffuse.reflectance;
        return texture < 0 ? ValuesAt<Index>(spectra_[table].at(index))
                           : textures_.reflectance({texture}, point, index);
    }

    /// How a material that is neither diffuse nor a mix scatters, for the path's channels. `seed` decides what a rough
    /// coat's estimates are.
    template <class Transport>
    [[nodiscard]] Bsdf<Transport::kChannels> bsdf(const PreparedMaterial& material, const TexturePoint& point,
                                                  const typename Transport::Index& index, Channels channels,
                                                  std::uint64_t seed) const noexcept;

    /// Whether bsdf() of this material holds for the first channel alone, whatever direction is drawn.
    [[nodiscard]] bool needs_one_channel(const PreparedMaterial& material, const TexturePoint& point) const noexcept;
    /// Whether its index of refraction differs between wavelengths, so that it splits light.
    [[nodiscard]] static bool disperses(const PreparedMaterial& material) noexcept;
    /// Whether its tangents matter.
    [[nodiscard]] bool is_anisotropic(const PreparedMaterial& material) const noexcept;
    /// Whether it uses the seed.
    [[nodiscard]] bool is_estimated(const PreparedMaterial& material) const noexcept {
        return std::holds_alternative<PreparedCoatedDiffuse>(material);
    }

  private:
    [[nodiscard]] float number(const PreparedNumber& number, const TexturePoint& point) const noexcept {
        return number.texture < 0 ? number.constant : textures_.number({number.texture}, point);
    }

    const SpectrumTables& spectra_;
    PreparedTextures textures_;
    std::vector<PreparedMaterial> materials_;
};

}  // namespace emulsion
