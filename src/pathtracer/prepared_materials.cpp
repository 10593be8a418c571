#include "pathtracer/prepared_materials.h"

#include <stdexcept>
#include <string>

#include "core/units.h"

namespace emulsion {

namespace {

/// Spectra that are the same at all wavelengths disperse nothing, however they are written.
bool is_constant(const Spectrum& spectrum) noexcept {
    const double first = eval(spectrum, static_cast<double>(kMinWavelength_nm));
    for (int lambda_nm = kMinWavelength_nm + 1; lambda_nm <= kMaxWavelength_nm; ++lambda_nm) {
        // Within what interpolation rounds.
        if (std::abs(eval(spectrum, static_cast<double>(lambda_nm)) - first) > 1e-9 * std::abs(first)) return false;
    }
    return true;
}

/// K of the coat at each whole nanometre.
Spectrum internal_reflectance(const CoatedDiffuseMaterial& coat) {
    if (is_constant(coat.eta))
        return ConstantSpectrum{coat_internal_reflectance(eval(coat.eta, 550.0), coat.thickness)};
    DenseSpectrum spectrum{static_cast<double>(kMinWavelength_nm), 1.0, {}};
    for (int lambda_nm = kMinWavelength_nm; lambda_nm <= kMaxWavelength_nm; ++lambda_nm) {
        const double eta = eval(coat.eta, static_cast<double>(lambda_nm));
        spectrum.value.push_back(coat_internal_reflectance(eta > 0.0 ? eta : 1.0, coat.thickness));
    }
    return spectrum;
}

class Preparation {
  public:
    explicit Preparation(SpectrumTables& spectra) : spectra_(spectra) {}

    PreparedMaterial operator()(const DiffuseMaterial& m) { return PreparedDiffuse{reflectance(m.reflectance)}; }
    PreparedMaterial operator()(const ConductorMaterial& m) {
        PreparedConductor prepared;
        prepared.roughness = roughness(m.roughness);
        if (const auto* ior = std::get_if<ComplexIor>(&m.ior)) {
            prepared.eta = spectra_.add_metal(ior->eta, ior->k);
            prepared.k = prepared.eta + 1;
        } else {
            prepared.reflectance = reflectance(std::get<ReflectanceParameter>(m.ior));
        }
        return prepared;
    }
    PreparedMaterial operator()(const DielectricMaterial& m) {
        return PreparedDielectric{spectra_.add_index(m.eta), !is_constant(m.eta), roughness(m.roughness)};
    }
    PreparedMaterial operator()(const ThinDielectricMaterial& m) {
        return PreparedThinDielectric{spectra_.add_index(m.eta)};
    }
    PreparedMaterial operator()(const DiffuseTransmissionMaterial& m) {
        return PreparedDiffuseTransmission{reflectance(m.reflectance), reflectance(m.transmittance),
                                           static_cast<float>(m.scale)};
    }
    PreparedMaterial operator()(const CoatedDiffuseMaterial& m) {
        PreparedCoatedDiffuse prepared;
        prepared.reflectance = reflectance(m.reflectance);
        prepared.eta = spectra_.add_index(m.eta);
        prepared.disperses = !is_constant(m.eta);
        prepared.internal_reflectance = spectra_.add_index(internal_reflectance(m));
        prepared.roughness = roughness(m.roughness);
        prepared.thickness = static_cast<float>(m.thickness);
        // A thousandth reflection within a coat carries nothing that could be seen, but would be waited for.
        constexpr int kMostTerms = 1000;
        prepared.terms = std::min((m.max_depth + 1) / 2, kMostTerms);
        return prepared;
    }
    PreparedMaterial operator()(const MixMaterial& m) {
        return PreparedMix{static_cast<std::uint32_t>(m.first), static_cast<std::uint32_t>(m.second), number(m.amount)};
    }
    // Shapes of it are left out of scenes: what is left is a material that no shape has.
    PreparedMaterial operator()(const InterfaceMaterial&) { return (*this)(DiffuseMaterial{}); }

  private:
    PreparedReflectance reflectance(const ReflectanceParameter& parameter) {
        if (const auto* texture = std::get_if<TextureIndex>(&parameter)) return {0, texture->index};
        return {spectra_.add_reflectance(std::get<Spectrum>(parameter)), -1};
    }
    static PreparedNumber number(const FloatParameter& parameter) {
        if (const auto* texture = std::get_if<TextureIndex>(&parameter)) return {0.0f, texture->index};
        return {static_cast<float>(std::get<double>(parameter)), -1};
    }
    static PreparedRoughness roughness(const Roughness& r) { return {number(r.u), number(r.v), r.remap, r.u != r.v}; }

    SpectrumTables& spectra_;
};

}  // namespace

PreparedMaterials::PreparedMaterials(const Scene& scene, SpectrumTables& spectra)
    : spectra_(spectra), textures_(scene.float_textures, scene.reflectance_textures, spectra) {
    const std::vector<Material>& materials = scene.materials;
    if (const auto mix = endless_mix(materials)) {
        throw std::invalid_argument("mix material " + std::to_string(*mix) + ": must not be part of itself");
    }
    Preparation prepare(spectra);
    materials_.reserve(materials.size());
    for (const Material& material : materials) materials_.push_back(std::visit(prepare, material));
}

std::optional<std::uint32_t> PreparedMaterials::constant_diffuse(std::uint32_t i) const {
    const auto* diffuse = std::get_if<PreparedDiffuse>(&materials_.at(i));
    if (diffuse == nullptr || diffuse->reflectance.texture >= 0) return std::nullopt;
    return diffuse->reflectance.table;
}

// --- Materials to BSDFs

namespace {

struct Facets {
    Ggx<float> ggx;
    bool smooth = true;
};

Facets facets_of(float u, float v, bool remap) noexcept {
    u = std::max(0.0f, u);
    v = std::max(0.0f, v);
    if (remap) {
        u = alpha_of_roughness(u);
        v = alpha_of_roughness(v);
    }
    return {Ggx<float>(u, v), std::max(u, v) < static_cast<float>(kSmoothAlpha)};
}

/// pbrt-v4 takes an index of 0, which tables have outside their range, for 1.
template <int N>
SampledSpectrum<N> index_or_one(SampledSpectrum<N> eta) noexcept {
    for (float& value : eta.value) value = value > 0.0f ? value : 1.0f;
    return eta;
}

template <class Transport>
class BsdfMaker {
  public:
    static constexpr int kN = Transport::kChannels;

    BsdfMaker(const SpectrumTables& spectra, const PreparedTextures& textures, const TexturePoint& point,
              const typename Transport::Index& index, Channels channels, std::uint64_t seed) noexcept
        : spectra_(spectra), textures_(textures), point_(point), index_(index), channels_(channels), seed_(seed) {}

    Bsdf<kN> operator()(const PreparedConductor& m) const noexcept {
        const Facets facets = facets_at(m.roughness);
        if (!m.reflectance) return ConductorBsdf<kN>{at(m.eta), at(m.k), facets.ggx, facets.smooth};
        // The k that has this reflectance at normal incidence with an eta of 1.
        SampledSpectrum<kN> k = at(*m.reflectance);
        for (float& value : k.value) {
            const float r = std::clamp(value, 0.0f, 0.9999f);
            value = 2.0f * std::sqrt(r / (1.0f - r));
        }
        return ConductorBsdf<kN>{SampledSpectrum<kN>(1.0f), k, facets.ggx, facets.smooth};
    }
    Bsdf<kN> operator()(const PreparedDielectric& m) const noexcept {
        Facets facets = facets_at(m.roughness);
        const SampledSpectrum<kN> eta = index_or_one(at(m.eta));
        if (eta[0] == 1.0f) facets.smooth = true;
        const bool disperses =
            Transport::kSpectral && m.disperses && facets.smooth && channels_ == Channels::all && kN > 1;
        return DielectricBsdf<kN>{eta, facets.ggx, facets.smooth, disperses};
    }
    Bsdf<kN> operator()(const PreparedThinDielectric& m) const noexcept {
        return ThinDielectricBsdf<kN>{index_or_one(at(m.eta))};
    }
    Bsdf<kN> operator()(const PreparedDiffuseTransmission& m) const noexcept {
        return DiffuseTransmissionBsdf<kN>{scaled(m.reflectance, m.scale), scaled(m.transmittance, m.scale)};
    }
    Bsdf<kN> operator()(const PreparedCoatedDiffuse& m) const noexcept {
        const Facets facets = facets_at(m.roughness);
        CoatedDiffuseBsdf<kN> bsdf;
        bsdf.reflectance = at(m.reflectance);
        bsdf.eta = index_or_one(at(m.eta))[0];
        bsdf.thickness = m.thickness;
        bsdf.terms = m.terms;
        bsdf.internal_reflectance = at(m.internal_reflectance)[0];
        bsdf.facets = facets.ggx;
        bsdf.smooth_coat = facets.smooth || bsdf.eta == 1.0f;
        bsdf.seed = seed_;
        return bsdf;
    }
    // The integrator scatters these itself.
    Bsdf<kN> operator()(const PreparedDiffuse&) const noexcept { return DiffuseTransmissionBsdf<kN>{}; }
    Bsdf<kN> operator()(const PreparedMix&) const noexcept { return DiffuseTransmissionBsdf<kN>{}; }

  private:
    [[nodiscard]] SampledSpectrum<kN> at(std::uint32_t table) const noexcept { return spectra_[table].at(index_); }
    [[nodiscard]] SampledSpectrum<kN> at(const PreparedReflectance& reflectance) const noexcept {
        if (reflectance.texture < 0) return at(reflectance.table);
        return textures_.reflectance({reflectance.texture}, point_, index_);
    }
    [[nodiscard]] float at(const PreparedNumber& number) const noexcept {
        return number.texture < 0 ? number.constant : textures_.number({number.texture}, point_);
    }
    [[nodiscard]] Facets facets_at(const PreparedRoughness& r) const noexcept {
        return facets_of(at(r.u), at(r.v), r.remap);
    }
    [[nodiscard]] SampledSpectrum<kN> scaled(const PreparedReflectance& reflectance, float scale) const noexcept {
        SampledSpectrum<kN> values = at(reflectance) * scale;
        for (float& value : values.value) value = std::clamp(value, 0.0f, 1.0f);
        return values;
    }

    const SpectrumTables& spectra_;
    const PreparedTextures& textures_;
    const TexturePoint& point_;
    const typename Transport::Index& index_;
    Channels channels_;
    std::uint64_t seed_;
};

}  // namespace

template <class Transport>
Bsdf<Transport::kChannels> PreparedMaterials::bsdf(const PreparedMaterial& material, const TexturePoint& point,
                                                   const typename Transport::Index& index, Channels channels,
                                                   std::uint64_t seed) const noexcept {
    return visit_noexcept(BsdfMaker<Transport>(spectra_, textures_, point, index, channels, seed), material);
}

bool PreparedMaterials::needs_one_channel(const PreparedMaterial& material, const TexturePoint& point) const noexcept {
    if (const auto* coated = std::get_if<PreparedCoatedDiffuse>(&material)) return coated->disperses;
    const auto* dielectric = std::get_if<PreparedDielectric>(&material);
    if (dielectric == nullptr || !dielectric->disperses) return false;
    const PreparedRoughness& r = dielectric->roughness;
    return !facets_of(number(r.u, point), number(r.v, point), r.remap).smooth;
}

bool PreparedMaterials::disperses(const PreparedMaterial& material) noexcept {
    return visit_noexcept(
        [](const auto& m) {
            if constexpr (requires { m.disperses; }) return m.disperses;
            return false;
        },
        material);
}

namespace {

const PreparedRoughness* roughness_of(const PreparedMaterial& material) noexcept {
    return visit_noexcept(
        [](const auto& m) -> const PreparedRoughness* {
            if constexpr (requires { m.roughness; }) return &m.roughness;
            return nullptr;
        },
        material);
}

}  // namespace

bool PreparedMaterials::is_anisotropic(const PreparedMaterial& material) const noexcept {
    const PreparedRoughness* roughness = roughness_of(material);
    return roughness != nullptr && roughness->anisotropic;
}

#define EMULSION_INSTANTIATE(TRANSPORT)                                                                 \
    template Bsdf<TRANSPORT::kChannels> PreparedMaterials::bsdf<TRANSPORT>(                             \
        const PreparedMaterial&, const TexturePoint&, const TRANSPORT::Index&, Channels, std::uint64_t) \
        const noexcept;
EMULSION_FOR_EACH_TRANSPORT(EMULSION_INSTANTIATE)

}  // namespace emulsion
