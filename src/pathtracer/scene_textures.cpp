#include "pathtracer/scene_textures.h"

#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include <fmt/format.h>

namespace emulsion {

namespace {

constexpr auto kKinds = std::to_array<KnownName>({{"float"}, {"spectrum"}});

/// The values of an image of the kind.
template <class Parameter>
using TexelOf = std::conditional_t<std::is_same_v<Parameter, FloatParameter>, float, RGB>;

/// The image that a parameter stands for, as a place in `textures`.
template <class Parameter, class Texture>
std::optional<std::size_t> image_of(const Parameter& parameter, const std::vector<Texture>& textures) noexcept {
    const auto* const texture = std::get_if<TextureIndex>(&parameter);
    if (texture == nullptr) return std::nullopt;
    const auto at = static_cast<std::size_t>(texture->index);
    if (!std::holds_alternative<ImageTexture<TexelOf<Parameter>>>(textures[at])) return std::nullopt;
    return at;
}

std::variant<TextureMapping, SolidTextureMapping> read_board_mapping(const ParameterList& list,
                                                                     const TextureContext& context) {
    const int dimension = integer_or(list, "dimension", 2);
    if (dimension == 2) return read_texture_mapping(list, context);
    if (dimension == 3) return read_solid_mapping(list, context);
    throw SceneError(find_parameter(list, "dimension")->first_value,
                     fmt::format("a checkerboard in {} dimensions", dimension), "2 or 3");
}

}  // namespace

// --- Parameters

template <class Parameter, class Texture, class OtherKind>
const Parameter& SceneTextures::look_up(const SceneParameter& parameter, const Kind<Parameter, Texture>& kind,
                                        const OtherKind& other) {
    const std::string& name = parameter.strings.front();
    const auto found = kind.named.find(name);
    if (found != kind.named.end()) return found->second.value;
    if (other.named.contains(name)) {
        throw SceneError(parameter.first_value, fmt::format("the {} texture {}", other.name, quote(name)),
                         fmt::format("a {} texture", kind.name));
    }
    std::vector<std::string_view> known;
    for (const auto& entry : kind.named) known.push_back(entry.first);
    throw SceneError(parameter.first_value, fmt::format("unknown {} texture {}", kind.name, quote(name)),
                     "one that a Texture directive before it makes" + nearest_hint(name, known));
}

FloatParameter SceneTextures::float_parameter(const SceneParameter& parameter) const {
    if (parameter.type != DeclaredType::texture) return parameter.numbers.front();
    return look_up(parameter, floats_, reflectances_);
}

ReflectanceParameter SceneTextures::reflectance_parameter(const SceneParameter& parameter,
                                                          SpectrumReader& spectra) const {
    if (parameter.type != DeclaredType::texture) return spectra.reflectance(parameter);
    return look_up(parameter, reflectances_, floats_);
}

FloatParameter SceneTextures::float_or(const ParameterList& list, std::string_view name, double otherwise) const {
    const SceneParameter* const parameter = find_parameter(list, name);
    return parameter == nullptr ? FloatParameter(otherwise) : float_parameter(*parameter);
}

ReflectanceParameter SceneTextures::reflectance_or(const ParameterList& list, std::string_view name, double otherwise,
                                                   SpectrumReader& spectra) const {
    const SceneParameter* const parameter = find_parameter(list, name);
    if (parameter != nullptr) return reflectance_parameter(*parameter, spectra);
    return Spectrum(ConstantSpectrum{otherwise});
}

template <class Parameter>
Parameter SceneTextures::operand(const ParameterList& list, std::string_view name, double otherwise,
                                 const TextureContext& context) const {
    if constexpr (std::is_same_v<Parameter, FloatParameter>) {
        return float_or(list, name, otherwise);
    } else {
        return reflectance_or(list, name, otherwise, context.spectra);
    }
}

// --- Textures

template <class Parameter, class Texture>
int SceneTextures::Kind<Parameter, Texture>::count(const Parameter& parameter) const noexcept {
    const auto* const texture = std::get_if<TextureIndex>(&parameter);
    return texture == nullptr ? 0 : evaluations[static_cast<std::size_t>(texture->index)];
}

void SceneTextures::make(const TextureDeclaration& declaration, const ParameterList& list,
                         const TextureContext& context) {
    const auto& kind = supported_row<KnownName>(declaration.kind_place, {"kind of texture"}, declaration.kind, kKinds);
    if (kind.name == floats_.name) {
        check_parameters(float_texture_table(), list);
        make(floats_, declaration, list, context);
    } else {
        check_parameters(reflectance_texture_table(), list);
        make(reflectances_, declaration, list, context);
    }
}

template <class Parameter, class Texture>
void SceneTextures::make(Kind<Parameter, Texture>& kind, const TextureDeclaration& declaration,
                         const ParameterList& list, const TextureContext& context) {
    const auto earlier = kind.named.find(declaration.name);
    if (earlier != kind.named.end()) {
        throw SceneError(declaration.name_place,
                         fmt::format("a second {} texture {}", kind.name, quote(declaration.name)),
                         "each name only once (the first is at " + to_text(earlier->second.made) + ")");
    }
    Parameter made = read(kind, list, context);
    kind.named.emplace(declaration.name, Named<Parameter>{std::move(made), declaration.name_place});
}

template <class Parameter, class Texture>
Parameter SceneTextures::read(Kind<Parameter, Texture>& kind, const ParameterList& list,
                              const TextureContext& context) {
    if (list.owner == "constant") return operand<Parameter>(list, "value", 1.0, context);
    if (list.owner == "scale") return read_scale(kind, list, context);
    if (list.owner == "mix") {
        MixTexture<Parameter> mix{operand<Parameter>(list, "tex1", 0.0, context),
                                  operand<Parameter>(list, "tex2", 1.0, context), float_or(list, "amount", 0.5)};
        const int evaluations = 1 + kind.count(mix.first) + kind.count(mix.second) + floats_.count(mix.amount);
        return add<Parameter, Texture>(kind, std::move(mix), evaluations, list, context);
    }
    if (list.owner == "checkerboard") {
        CheckerboardTexture<Parameter> board{operand<Parameter>(list, "tex1", 1.0, context),
                                             operand<Parameter>(list, "tex2", 0.0, context),
                                             read_board_mapping(list, context)};
        const int evaluations = 1 + kind.count(board.first) + kind.count(board.second);
        return add<Parameter, Texture>(kind, std::move(board), evaluations, list, context);
    }
    return add<Parameter, Texture>(kind, imagemaps_.read<TexelOf<Parameter>>(list, context), 1, list, context);
}

template <class Parameter, class Texture>
Parameter SceneTextures::read_scale(Kind<Parameter, Texture>& kind, const ParameterList& list,
                                    const TextureContext& context) {
    std::vector<Texture>& textures = context.scene.*kind.textures;
    // pbrt-v4 scales images before they are inverted and clamped.
    const auto scaled_image = [&](std::size_t at, double factor) {
        auto scaled = add<Parameter, Texture>(kind, textures[at], 1, list, context);
        std::get<ImageTexture<TexelOf<Parameter>>>(textures.back()).scale *= factor;
        return scaled;
    };
    ScaleTexture<Parameter> scale{operand<Parameter>(list, "tex", 1.0, context), float_or(list, "scale", 1.0)};
    if (const auto* const factor = std::get_if<double>(&scale.scale)) {
        if (*factor == 1.0) return scale.texture;
        if (const auto image = image_of(scale.texture, textures)) return scaled_image(*image, *factor);
    }
    if constexpr (std::is_same_v<Parameter, FloatParameter>) {
        if (const auto* const factor = std::get_if<double>(&scale.texture)) {
            if (*factor == 1.0) return scale.scale;
            if (const auto* const other = std::get_if<double>(&scale.scale)) return *factor * *other;
            if (const auto image = image_of(scale.scale, textures)) return scaled_image(*image, *factor);
        }
    }
    const int evaluations = 1 + kind.count(scale.texture) + floats_.count(scale.scale);
    return add<Parameter, Texture>(kind, std::move(scale), evaluations, list, context);
}

template <class Parameter, class Texture>
Parameter SceneTextures::add(Kind<Parameter, Texture>& kind, Texture texture, int evaluations,
                             const ParameterList& list, const TextureContext& context) {
    if (evaluations > kMaxEvaluations) {
        throw SceneError(list.place, fmt::format("a texture of {} evaluations of textures", evaluations),
                         fmt::format("at most {}", kMaxEvaluations));
    }
    std::vector<Texture>& textures = context.scene.*kind.textures;
    textures.push_back(std::move(texture));
    kind.evaluations.push_back(evaluations);
    return TextureIndex{static_cast<int>(textures.size()) - 1};
}

}  // namespace emulsion
