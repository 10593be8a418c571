#include "pathtracer/aux_layers.h"

#include <stdexcept>
#include <variant>

#include "core/units.h"
#include "pathtracer/fresnel.h"
#include "spectrum/reflectance_weights.h"
#include "spectrum/rgb_space.h"

namespace emulsion {

namespace {

/// The share of light that a material gives back, whichever way: of metals that at normal incidence, of glass all, of
/// coats that of what lies below.
class AlbedoOf {
  public:
    explicit AlbedoOf(const std::vector<Material>& materials) : materials_(materials) {}

    std::array<double, 3> operator()(const DiffuseMaterial& m) const { return of(m.reflectance); }
    std::array<double, 3> operator()(const CoatedDiffuseMaterial& m) const { return of(m.reflectance); }
    std::array<double, 3> operator()(const DielectricMaterial&) const { return {1.0, 1.0, 1.0}; }
    std::array<double, 3> operator()(const ThinDielectricMaterial&) const { return {1.0, 1.0, 1.0}; }
    std::array<double, 3> operator()(const InterfaceMaterial&) const { return {1.0, 1.0, 1.0}; }
    std::array<double, 3> operator()(const ConductorMaterial& m) const {
        const auto* ior = std::get_if<ComplexIor>(&m.ior);
        if (ior == nullptr) return of(std::get<ReflectanceParameter>(m.ior));
        DenseSpectrum mirror{static_cast<double>(kMinWavelength_nm), 1.0, {}};
        for (int lambda_nm = kMinWavelength_nm; lambda_nm <= kMaxWavelength_nm; ++lambda_nm) {
            const double eta = eval(ior->eta, lambda_nm), k = eval(ior->k, lambda_nm);
            mirror.value.push_back(fresnel_conductor(1.0, eta, k));
        }
        return of(Spectrum(mirror));
    }
    std::array<double, 3> operator()(const DiffuseTransmissionMaterial& m) const {
        return mixed(of(m.reflectance), of(m.transmittance), m.scale, m.scale);
    }
    std::array<double, 3> operator()(const MixMaterial& m) const {
        const double amount = std::get<double>(m.amount);
        return mixed(std::visit(*this, materials_.at(static_cast<std::size_t>(m.first))),
                     std::visit(*this, materials_.at(static_cast<std::size_t>(m.second))), 1.0 - amount, amount);
    }

  private:
    [[nodiscard]] std::array<double, 3> of(const ReflectanceParameter& reflectance) const {
        return weighted_sums(rgb_.rgb_weights, std::get<Spectrum>(reflectance));
    }
    static std::array<double, 3> mixed(const std::array<double, 3>& a, const std::array<double, 3>& b, double of_a,
                                       double of_b) {
        return {of_a * a[0] + of_b * b[0], of_a * a[1] + of_b * b[1], of_a * a[2] + of_b * b[2]};
    }

    const std::vector<Material>& materials_;
    ReflectanceRgb rgb_ = reflectance_rgb(rgb_space("sRGB"));
};

std::vector<std::array<float, 3>> albedos_of(const std::vector<Material>& materials) {
    const AlbedoOf albedo_of(materials);
    std::vector<std::array<float, 3>> albedos;
    for (const Material& material : materials) {
        const auto [r, g, b] = std::visit(albedo_of, material);
        albedos.push_back({static_cast<float>(r), static_cast<float>(g), static_cast<float>(b)});
    }
    return albedos;
}

}  // namespace

void note_first_hits(const PreparedScene& scene, std::span<const Ray> rays, std::span<const Hit> hits,
                     std::span<FirstHit> first_hits) noexcept {
    for (std::size_t i = 0; i < hits.size(); ++i) {
        first_hits[i] = {};
        if (hits[i].shape == Hit::kNone) continue;
        const Imath::V3f normal = surface_point(scene, rays[i], hits[i]).shading_normal;
        const bool front = rays[i].direction.dot(normal) < 0.0f;
        first_hits[i] = {hits[i].shape, hits[i].t, front ? normal : -normal};
    }
}

AuxLayers::AuxLayers(const Scene& scene, const std::vector<AuxLayer>& layers) : scene_(scene) {
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const AuxLayer known = known_aux_layer(layers[i].name);
        if (layers[i].components != known.components) {
            throw std::invalid_argument("auxiliary layer \"" + known.name + "\" has " +
                                        std::to_string(layers[i].components.size()) +
                                        " components, expected those of known_aux_layers()");
        }
        (known.name == "albedo" ? albedo_layer_ : known.name == "normal" ? normal_layer_ : depth_layer_) = i;
    }
    if (albedo_layer_) material_albedo_ = albedos_of(scene.materials);
}

template <class Add>
void AuxLayers::for_each(const FirstHit& hit, const Add& add) const noexcept {
    if (hit.shape == Hit::kNone) return;
    if (albedo_layer_) {
        add(*albedo_layer_, material_albedo_[static_cast<std::size_t>(scene_.shapes[hit.shape].material)]);
    }
    if (normal_layer_) {
        add(*normal_layer_, std::array{hit.facing_normal.x, hit.facing_normal.y, hit.facing_normal.z});
    }
    if (depth_layer_) add(*depth_layer_, std::array{hit.distance});
}

void AuxLayers::add(FilmTile& tile, int x, int y, float weight, const FirstHit& hit) const noexcept {
    for_each(hit, [&](std::size_t layer, std::span<const float> values) { tile.add_aux(x, y, layer, values, weight); });
}

void AuxLayers::add_at(FilmTile& tile, float x_px, float y_px, const FirstHit& hit) const noexcept {
    for_each(hit,
             [&](std::size_t layer, std::span<const float> values) { tile.add_aux_at(x_px, y_px, layer, values); });
}

}  // namespace emulsion
