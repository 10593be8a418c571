#include "pathtracer/scene_materials.h"

#include <array>

#include <fmt/format.h>

#include "spectrum/named_spectra.h"

namespace emulsion {

namespace {

class MaterialReader {
  public:
    MaterialReader(const ParameterList& list, const MaterialContext& context) : list_(list), context_(context) {}

    [[nodiscard]] Material diffuse() const { return DiffuseMaterial{reflectance("reflectance", 0.5)}; }

    [[nodiscard]] Material conductor() const {
        const SceneParameter* const eta = find_parameter(list_, "eta");
        const SceneParameter* const k = find_parameter(list_, "k");
        if (const SceneParameter* const given = find_parameter(list_, "reflectance")) {
            const SceneParameter* const other = eta != nullptr ? eta : k;
            if (other != nullptr) {
                throw SceneError(other->place, fmt::format("\"{}\" beside \"reflectance\"", other->name),
                                 "either the reflectance, or eta and k");
            }
            return ConductorMaterial{reflectance(given->name, 0.0), roughness()};
        }
        const auto or_copper = [this](const SceneParameter* parameter, std::string_view name) {
            return parameter != nullptr ? context_.spectra.index_of_refraction(*parameter)
                                        : named_spectrum(name).value();
        };
        return ConductorMaterial{ComplexIor{or_copper(eta, "metal-Cu-eta"), or_copper(k, "metal-Cu-k")}, roughness()};
    }

    [[nodiscard]] Material dielectric() const { return DielectricMaterial{eta(), roughness()}; }
    [[nodiscard]] Material thin_dielectric() const { return ThinDielectricMaterial{eta()}; }

    [[nodiscard]] Material diffuse_transmission() const {
        // Clamped once they are scaled, as in pbrt-v4.
        return DiffuseTransmissionMaterial{unclamped_reflectance("reflectance", 0.25),
                                           unclamped_reflectance("transmittance", 0.25), real_or(list_, "scale", 1.0)};
    }

    [[nodiscard]] Material coated_diffuse() const {
        refuse_medium();
        CoatedDiffuseMaterial material;
        material.reflectance = reflectance("reflectance", 0.5);
        material.eta = eta();
        material.roughness = roughness();
        material.thickness = real_or(list_, "thickness", material.thickness);
        material.max_depth = integer_or(list_, "maxdepth", material.max_depth);
        return material;
    }

    [[nodiscard]] Material mix() const {
        const SceneParameter* const names = find_parameter(list_, "materials");
        if (names == nullptr) {
            throw SceneError(list_.place, "a mix without materials", "a parameter \"string materials\" of two names");
        }
        MixMaterial material;
        material.first = context_.named(place_of_value(*names, 0), names->strings[0]);
        material.second = context_.named(place_of_value(*names, 1), names->strings[1]);
        material.amount = context_.textures.float_or(list_, "amount", 0.5);
        return material;
    }

    [[nodiscard]] Material interface() const { return InterfaceMaterial{}; }

  private:
    [[nodiscard]] ReflectanceParameter unclamped_reflectance(std::string_view name, double otherwise) const {
        return context_.textures.reflectance_or(list_, name, otherwise, context_.spectra);
    }
    [[nodiscard]] ReflectanceParameter reflectance(std::string_view name, double otherwise) const {
        ReflectanceParameter parameter = unclamped_reflectance(name, otherwise);
        auto* const spectrum = std::get_if<Spectrum>(&parameter);
        if (spectrum != nullptr) *spectrum = clamped_reflectance(std::move(*spectrum));
        return parameter;
    }

    [[nodiscard]] Spectrum eta() const {
        const SceneParameter* const parameter = find_parameter(list_, "eta");
        if (parameter == nullptr) return ConstantSpectrum{1.5};
        const bool is_number = parameter->type == DeclaredType::real || parameter->type == DeclaredType::integer;
        if (!is_number) return context_.spectra.index_of_refraction(*parameter);
        const double value = parameter->numbers.front();
        if (!(value > 0.0)) {
            throw SceneError(parameter->first_value, fmt::format("an index of refraction of {}", value),
                             "a number above 0");
        }
        return ConstantSpectrum{value};
    }

    [[nodiscard]] Roughness roughness() const {
        const FloatParameter both = context_.textures.float_or(list_, "roughness", 0.0);
        const auto along = [&](std::string_view name) {
            const SceneParameter* const parameter = find_parameter(list_, name);
            return parameter == nullptr ? both : context_.textures.float_parameter(*parameter);
        };
        return {along("uroughness"), along("vroughness"), flag_or(list_, "remaproughness", Flag::on) == Flag::on};
    }

    /// There are no media here, not even in coats; `g` and `nsamples` are about them.
    void refuse_medium() const {
        const SceneParameter* const albedo = find_parameter(list_, "albedo");
        if (albedo == nullptr) return;
        const Spectrum spectrum = context_.spectra.reflectance(*albedo);
        for (int lambda_nm = 360; lambda_nm <= 830; ++lambda_nm) {
            if (eval(spectrum, lambda_nm) == 0.0) continue;
            throw SceneError(albedo->first_value, "a coat with a medium that scatters",
                             "an albedo of 0 (others are known to pbrt-v4 and not yet supported here)");
        }
    }

    const ParameterList& list_;
    const MaterialContext& context_;
};

struct MaterialRow {
    std::string_view name;
    Material (MaterialReader::*read)() const;
};
constexpr auto kReaders = std::to_array<MaterialRow>({{"diffuse", &MaterialReader::diffuse},
                                                      {"conductor", &MaterialReader::conductor},
                                                      {"dielectric", &MaterialReader::dielectric},
                                                      {"thindielectric", &MaterialReader::thin_dielectric},
                                                      {"diffusetransmission", &MaterialReader::diffuse_transmission},
                                                      {"coateddiffuse", &MaterialReader::coated_diffuse},
                                                      {"mix", &MaterialReader::mix},
                                                      {"interface", &MaterialReader::interface}});

}  // namespace

Material read_material(const ParameterList& list, const MaterialContext& context) {
    check_parameters(material_table(), list);
    const auto& row = supported_row<MaterialRow>(list.place, {"material"}, list.owner, kReaders);
    return (MaterialReader(list, context).*row.read)();
}

}  // namespace emulsion
