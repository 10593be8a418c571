#include "pathtracer/material_albedo.h"

#include <algorithm>
#include <variant>

#include "pathtracer/model_channels.h"
#include "spectrum/reflectance_weights.h"
#include "spectrum/rgb_space.h"

namespace emulsion {

/// Of one material at a point.
class MaterialAlbedos::AlbedoOf {
  public:
    AlbedoOf(const MaterialAlbedos& albedos, const TexturePoint& point) : albedos_(albedos), point_(point) {}

    /// Whether any texture was looked up.
    [[nodiscard]] bool textured() const noexcept { return textured_; }

    std::array<double, 3> of_material(int i) {
        return std::visit([this](const auto& m) { return (*this)(m); },
                          albedos_.scene_.materials.at(static_cast<std::size_t>(i)));
    }
    std::array<double, 3> operator()(const DiffuseMaterial& m) { return of(m.reflectance); }
    std::array<double, 3> operator()(const CoatedDiffuseMaterial& m) { return of(m.reflectance); }
    std::array<double, 3> operator()(const DielectricMaterial&) { return {1.0, 1.0, 1.0}; }
    std::array<double, 3> operator()(const ThinDielectricMaterial&) { return {1.0, 1.0, 1.0}; }
    std::array<double, 3> operator()(const InterfaceMaterial&) { return {1.0, 1.0, 1.0}; }
    std::array<double, 3> operator()(const ConductorMaterial& m) {
        const auto* ior = std::get_if<ComplexIor>(&m.ior);
        if (ior == nullptr) return of(std::get<ReflectanceParameter>(m.ior));
        return of(normal_reflectance(ior->eta, ior->k));
    }
    std::array<double, 3> operator()(const DiffuseTransmissionMaterial& m) {
        return mixed(of(m.reflectance), of(m.transmittance), m.scale, m.scale);
    }
    std::array<double, 3> operator()(const MixMaterial& m) {
        const auto* texture = std::get_if<TextureIndex>(&m.amount);
        textured_ = textured_ || texture != nullptr;
        const double amount =
            texture == nullptr
                ? std::get<double>(m.amount)
                : static_cast<double>(std::clamp(albedos_.textures_.number(*texture, point_), 0.0f, 1.0f));
        return mixed(of_material(m.first), of_material(m.second), 1.0 - amount, amount);
    }

  private:
    std::array<double, 3> of(const ReflectanceParameter& reflectance) {
        const auto* texture = std::get_if<TextureIndex>(&reflectance);
        if (texture == nullptr) return weighted_sums(albedos_.rgb_.rgb_weights, std::get<Spectrum>(reflectance));
        textured_ = true;
        const SampledSpectrum<3> rgb = albedos_.textures_.reflectance(*texture, point_, FixedIndex<3>{});
        return {rgb[0], rgb[1], rgb[2]};
    }
    static std::array<double, 3> mixed(const std::array<double, 3>& a, const std::array<double, 3>& b, double of_a,
                                       double of_b) {
        return {of_a * a[0] + of_b * b[0], of_a * a[1] + of_b * b[1], of_a * a[2] + of_b * b[2]};
    }

    const MaterialAlbedos& albedos_;
    const TexturePoint& point_;
    bool textured_ = false;
};

MaterialAlbedos::MaterialAlbedos(const Scene& scene)
    : scene_(scene),
      rgb_(reflectance_rgb(rgb_space("sRGB"))),
      textures_(scene.float_textures, scene.reflectance_textures, spectra_) {
    const FixedChannels srgb = rgb_channels("sRGB");
    spectra_.prepare(srgb);
    textures_.prepare(srgb);
    for (int i = 0; i < static_cast<int>(scene.materials.size()); ++i) {
        bool textured = false;
        const std::array<float, 3> albedo = at(i, {}, textured);
        constant_.push_back(textured ? std::nullopt : std::optional(albedo));
    }
}

std::array<float, 3> MaterialAlbedos::operator()(int material, const TexturePoint& point) const {
    const auto& constant = constant_[static_cast<std::size_t>(material)];
    bool textured = false;
    return constant ? *constant : at(material, point, textured);
}

std::array<float, 3> MaterialAlbedos::at(int material, const TexturePoint& point, bool& textured) const {
    AlbedoOf albedo_of(*this, point);
    const auto [r, g, b] = albedo_of.of_material(material);
    textured = albedo_of.textured();
    return {static_cast<float>(r), static_cast<float>(g), static_cast<float>(b)};
}

}  // namespace emulsion
