#include "pathtracer/prepared_materials.h"

#include <stdexcept>
#include <string>
#include <utility>

#include "core/units.h"

namespace emulsion {

namespace {

/// Spectra that are the same at all wavelengths disperse nothing.
bool is_constant(const Spectrum& spectrum) noexcept { return std::holds_alternative<ConstantSpectrum>(spectrum); }

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
            prepared.eta = spectra_.add_property(ior->eta);
            prepared.k = spectra_.add_property(ior->k);
        } else {
            prepared.reflectance = reflectance(std::get<ReflectanceParameter>(m.ior));
        }
        return prepared;
    }
    PreparedMaterial operator()(const DielectricMaterial& m) {
        return PreparedDielectric{spectra_.add_property(m.eta), !is_constant(m.eta), roughness(m.roughness)};
    }
    PreparedMaterial operator()(const ThinDielectricMaterial& m) {
        return PreparedThinDielectric{spectra_.add_property(m.eta)};
    }
    PreparedMaterial operator()(const DiffuseTransmissionMaterial& m) {
        return PreparedDiffuseTransmission{reflectance(m.reflectance), reflectance(m.transmittance),
                                           static_cast<float>(m.scale)};
    }
    PreparedMaterial operator()(const CoatedDiffuseMaterial& m) {
        PreparedCoatedDiffuse prepared;
        prepared.reflectance = reflectance(m.reflectance);
        prepared.eta = spectra_.add_property(m.eta);
        prepared.disperses = !is_constant(m.eta);
        prepared.internal_reflectance = spectra_.add_property(internal_reflectance(m));
        prepared.roughness = roughness(m.roughness);
        prepared.thickness = static_cast<float>(m.thickness);
        prepared.terms = (m.max_depth + 1) / 2;
        return prepared;
    }
    PreparedMaterial operator()(const MixMaterial& m) {
        return PreparedMix{static_cast<std::uint32_t>(m.first), static_cast<std::uint32_t>(m.second), number(m.amount)};
    }
    // Shapes of it are left out of scenes: what is left is a material that no shape has.
    PreparedMaterial operator()(const InterfaceMaterial&) { return (*this)(DiffuseMaterial{}); }

    /// Whether a texture was met since the last call.
    bool take_textured() noexcept { return std::exchange(textured_, false); }

  private:
    PreparedReflectance reflectance(const ReflectanceParameter& parameter) {
        if (const auto* texture = std::get_if<TextureIndex>(&parameter)) return {0, textured(*texture)};
        return {spectra_.add_property(std::get<Spectrum>(parameter)), std::nullopt};
    }
    PreparedNumber number(const FloatParameter& parameter) {
        if (const auto* texture = std::get_if<TextureIndex>(&parameter)) return {0.0f, textured(*texture)};
        return {static_cast<float>(std::get<double>(parameter)), std::nullopt};
    }
    TextureIndex textured(TextureIndex texture) noexcept {
        textured_ = true;
        return texture;
    }
    PreparedRoughness roughness(const Roughness& r) { return {number(r.u), number(r.v), r.remap}; }

    SpectrumTables& spectra_;
    bool textured_ = false;
};

/// All materials, each after those that it is mixed from. Mixes refer to materials by index: each of them must come to
/// an end.
std::vector<std::size_t> parts_first(const std::vector<Material>& materials) {
    std::vector<std::size_t> order;
    enum class State : std::uint8_t { unseen, open, ends };
    std::vector<State> states(materials.size(), State::unseen);
    std::vector<int> stack;
    for (int start = 0; start < static_cast<int>(materials.size()); ++start) {
        stack.push_back(start);
        while (!stack.empty()) {
            const auto top = static_cast<std::size_t>(stack.back());
            const auto* mix = std::get_if<MixMaterial>(&materials[top]);
            if (states[top] != State::unseen || mix == nullptr) {
                if (states[top] != State::ends) order.push_back(top);
                states[top] = State::ends;
                stack.pop_back();
                continue;
            }
            states[top] = State::open;
            for (const int part : {mix->first, mix->second}) {
                const auto i = static_cast<std::size_t>(part);
                if (i >= materials.size()) {
                    throw std::invalid_argument("mix material " + std::to_string(top) + ": part " +
                                                std::to_string(part) + " must be one of " +
                                                std::to_string(materials.size()) + " materials");
                }
                if (states[i] == State::open) {
                    throw std::invalid_argument("mix material " + std::to_string(i) + ": must not be part of itself");
                }
                if (states[i] == State::unseen) stack.push_back(part);
            }
        }
    }
    return order;
}

}  // namespace

PreparedMaterials::PreparedMaterials(const std::vector<Material>& materials, SpectrumTables& spectra,
                                     const PreparedTextures& textures)
    : spectra_(spectra), textures_(textures) {
    const std::vector<std::size_t> order = parts_first(materials);
    Preparation prepare(spectra);
    materials_.reserve(materials.size());
    for (const Material& material : materials) {
        materials_.push_back(std::visit(prepare, material));
        textured_.push_back(prepare.take_textured() ? 1 : 0);
    }
    for (const std::size_t i : order) {
        if (const auto* mix = std::get_if<PreparedMix>(&materials_[i])) {
            if (textured_[mix->first] != 0 || textured_[mix->second] != 0) textured_[i] = 1;
        }
    }
}

std::optional<std::uint32_t> PreparedMaterials::constant_diffuse(std::uint32_t i) const {
    const auto* diffuse = std::get_if<PreparedDiffuse>(&materials_.at(i));
    if (diffuse == nullptr || diffuse->reflectance.texture) return std::nullopt;
    return diffuse->reflectance.table;
}

// --- Materials to BSDFs

namespace {

struct Facets {
    Ggx<float> ggx;
    bool smooth = true;
};

Facets facets_of(const PreparedMaterials& materials, const PreparedRoughness& roughness,
                 const TexturePoint& point) noexcept {
    float u = std::max(0.0f, materials.number(roughness.u, point));
    float v = std::max(0.0f, materials.number(roughness.v, point));
    if (roughness.remap) {
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
    static constexpr int N = Transport::kChannels;
    static constexpr bool kSpectral = !std::is_same_v<Transport, RgbTransport>;

    BsdfMaker(const SpectrumTables& spectra, const PreparedMaterials& materials, const TexturePoint& point,
              const typename Transport::Index& index, Channels channels, std::uint64_t seed) noexcept
        : spectra_(spectra), materials_(materials), point_(point), index_(index), channels_(channels), seed_(seed) {}

    Bsdf<N> operator()(const PreparedConductor& m) const noexcept {
        const Facets facets = facets_at(m.roughness);
        if (!m.reflectance) return ConductorBsdf<N>{at(m.eta), at(m.k), facets.ggx, facets.smooth};
        // The k that has this reflectance at normal incidence with an eta of 1.
        SampledSpectrum<N> k = at(*m.reflectance);
        for (float& value : k.value) {
            const float r = std::clamp(value, 0.0f, 0.9999f);
            value = 2.0f * std::sqrt(r / (1.0f - r));
        }
        return ConductorBsdf<N>{SampledSpectrum<N>(1.0f), k, facets.ggx, facets.smooth};
    }
    Bsdf<N> operator()(const PreparedDielectric& m) const noexcept {
        Facets facets = facets_at(m.roughness);
        const SampledSpectrum<N> eta = shared_by_colours(index_or_one(at(m.eta)));
        if (eta[0] == 1.0f) facets.smooth = true;
        const bool disperses = kSpectral && m.disperses && facets.smooth && channels_ == Channels::all && N > 1;
        return DielectricBsdf<N>{eta, facets.ggx, facets.smooth, disperses};
    }
    Bsdf<N> operator()(const PreparedThinDielectric& m) const noexcept {
        return ThinDielectricBsdf<N>{index_or_one(at(m.eta))};
    }
    Bsdf<N> operator()(const PreparedDiffuseTransmission& m) const noexcept {
        return DiffuseTransmissionBsdf<N>{scaled(m.reflectance, m.scale), scaled(m.transmittance, m.scale)};
    }
    Bsdf<N> operator()(const PreparedCoatedDiffuse& m) const noexcept {
        const Facets facets = facets_at(m.roughness);
        CoatedDiffuseBsdf<N> bsdf;
        bsdf.reflectance = at(m.reflectance);
        bsdf.eta = shared_by_colours(index_or_one(at(m.eta)))[0];
        bsdf.thickness = m.thickness;
        bsdf.terms = m.terms;
        bsdf.internal_reflectance = at(m.internal_reflectance)[0];
        bsdf.facets = facets.ggx;
        bsdf.smooth_coat = facets.smooth || bsdf.eta == 1.0f;
        bsdf.seed = seed_;
        return bsdf;
    }
    // The integrator scatters these itself.
    Bsdf<N> operator()(const PreparedDiffuse&) const noexcept { return DiffuseTransmissionBsdf<N>{}; }
    Bsdf<N> operator()(const PreparedMix&) const noexcept { return DiffuseTransmissionBsdf<N>{}; }

  private:
    SampledSpectrum<N> at(std::uint32_t table) const noexcept { return spectra_[table].at(index_); }
    SampledSpectrum<N> at(const PreparedReflectance& reflectance) const noexcept {
        return materials_.template reflectance<Transport>(reflectance, point_, index_);
    }
    Facets facets_at(const PreparedRoughness& roughness) const noexcept {
        return facets_of(materials_, roughness, point_);
    }
    SampledSpectrum<N> scaled(const PreparedReflectance& reflectance, float scale) const noexcept {
        SampledSpectrum<N> values = at(reflectance) * scale;
        for (float& value : values.value) value = std::clamp(value, 0.0f, 1.0f);
        return values;
    }
    /// Colours share one direction, that of green.
    static SampledSpectrum<N> shared_by_colours(const SampledSpectrum<N>& eta) noexcept {
        if constexpr (kSpectral) return eta;
        return SampledSpectrum<N>(eta[1 % N]);
    }

    const SpectrumTables& spectra_;
    const PreparedMaterials& materials_;
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
    return visit_noexcept(BsdfMaker<Transport>(spectra_, *this, point, index, channels, seed), material);
}

bool PreparedMaterials::needs_one_channel(const PreparedMaterial& material, const TexturePoint& point) const noexcept {
    if (const auto* coated = std::get_if<PreparedCoatedDiffuse>(&material)) return coated->disperses;
    const auto* dielectric = std::get_if<PreparedDielectric>(&material);
    return dielectric != nullptr && dielectric->disperses && !facets_of(*this, dielectric->roughness, point).smooth;
}

#define EMULSION_INSTANTIATE(TRANSPORT)                                                                 \
    template Bsdf<TRANSPORT::kChannels> PreparedMaterials::bsdf<TRANSPORT>(                             \
        const PreparedMaterial&, const TexturePoint&, const TRANSPORT::Index&, Channels, std::uint64_t) \
        const noexcept;
EMULSION_FOR_EACH_TRANSPORT(EMULSION_INSTANTIATE)

}  // namespace emulsion
