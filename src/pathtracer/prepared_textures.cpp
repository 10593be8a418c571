#include "pathtracer/prepared_textures.h"

#include <algorithm>
#include <cmath>

#include "core/visit.h"
#include "pathtracer/texture_lookup.h"
#include "pathtracer/texture_mapping.h"

namespace emulsion {

namespace {

/// Whether a point lies on a field of the first kind. pbrt-v4 blends the two over 1.5 times the ray's footprint, which
/// has the same mean over a pixel.
bool on_first_field(const std::variant<TextureMapping, SolidTextureMapping>& mapping,
                    const TexturePoint& point) noexcept {
    if (const auto* const solid = std::get_if<SolidTextureMapping>(&mapping)) {
        const Imath::V3d p = map(*solid, point);
        return std::fmod(std::floor(p.x) + std::floor(p.y) + std::floor(p.z), 2.0) == 0.0;
    }
    const Imath::V2d st = map(*std::get_if<TextureMapping>(&mapping), point);
    return std::fmod(std::floor(st.x) + std::floor(st.y), 2.0) == 0.0;
}

float value_of(const ImageTexture<float>& texture, const TexturePoint& point) noexcept {
    const float texel = static_cast<float>(texture.scale) *
                        lookup(texture.image->texels, texture.wrap, texture.filter, map(texture.mapping, point));
    return texture.invert ? std::max(0.0f, 1.0f - texel) : texel;
}

/// In the linear RGB of the image, not clamped.
RGB colour_of(const ImageTexture<RGB>& texture, const TexturePoint& point) noexcept {
    const RGB texel = static_cast<float>(texture.scale) *
                      lookup(texture.image->texels, texture.wrap, texture.filter, map(texture.mapping, point));
    return texture.invert ? RGB{1.0f, 1.0f, 1.0f} + -1.0f * texel : texel;
}

}  // namespace

// --- Preparation

PreparedTextures::PreparedTextures(std::span<const FloatTexture> numbers,
                                   std::span<const ReflectanceTexture> reflectances, SpectrumTables& spectra)
    : spectra_(spectra) {
    for (const FloatTexture& texture : numbers) {
        numbers_.push_back(prepared_node<Node<NumberOperand, float>>(texture, spectra));
    }
    for (const ReflectanceTexture& texture : reflectances) {
        reflectances_.push_back(prepared_node<Node<ReflectanceOperand, RGB>>(texture, spectra));
        const auto* const image = std::get_if<ImageTexture<RGB>>(&texture);
        if (image == nullptr) continue;
        auto& colours = colours_.at(static_cast<std::size_t>(image->image->space));
        if (!colours) colours.emplace(image->image->space);
    }
}

PreparedTextures::NumberOperand PreparedTextures::prepared(const FloatParameter& parameter, SpectrumTables&) {
    if (const auto* texture = std::get_if<TextureIndex>(&parameter)) return {0.0f, texture->index};
    return {static_cast<float>(std::get<double>(parameter)), -1};
}

PreparedTextures::ReflectanceOperand PreparedTextures::prepared(const ReflectanceParameter& parameter,
                                                                SpectrumTables& spectra) {
    if (const auto* texture = std::get_if<TextureIndex>(&parameter)) return {0, texture->index};
    return {spectra.add_reflectance(std::get<Spectrum>(parameter)), -1};
}

template <class NodeType, class Texture>
NodeType PreparedTextures::prepared_node(const Texture& texture, SpectrumTables& spectra) {
    const auto prepare = [&spectra](const auto& given) -> NodeType {
        if constexpr (requires { given.image; }) {
            return given;
        } else if constexpr (requires { given.scale; }) {
            return Scale<decltype(prepared(given.texture, spectra))>{prepared(given.texture, spectra),
                                                                     prepared(given.scale, spectra)};
        } else if constexpr (requires { given.amount; }) {
            return Mix<decltype(prepared(given.first, spectra))>{
                prepared(given.first, spectra), prepared(given.second, spectra), prepared(given.amount, spectra)};
        } else {
            static_assert(
                requires { given.mapping; }, "a kind of texture that is not prepared");
            return Checkerboard<decltype(prepared(given.first, spectra))>{
                prepared(given.first, spectra), prepared(given.second, spectra), given.mapping};
        }
    };
    return std::visit(prepare, texture);
}

void PreparedTextures::prepare(const FixedChannels& channels) {
    for (auto& colours : colours_) {
        if (colours) colours->prepare(channels);
    }
}

// --- Lookup

float PreparedTextures::number(TextureIndex texture, const TexturePoint& point) const noexcept {
    const auto evaluate = [&](const auto& node) noexcept -> float {
        if constexpr (requires { node.image; }) {
            return value_of(node, point);
        } else if constexpr (requires { node.scale; }) {
            return value(node.texture, point) * value(node.scale, point);
        } else if constexpr (requires { node.amount; }) {
            const float amount = value(node.amount, point);
            return (1.0f - amount) * value(node.first, point) + amount * value(node.second, point);
        } else {
            return value(on_first_field(node.mapping, point) ? node.first : node.second, point);
        }
    };
    return visit_noexcept(evaluate, numbers_[static_cast<std::size_t>(texture.index)]);
}

float PreparedTextures::value(const NumberOperand& operand, const TexturePoint& point) const noexcept {
    return operand.texture < 0 ? operand.constant : number({operand.texture}, point);
}

template <class Index>
ValuesAt<Index> PreparedTextures::value(const ReflectanceOperand& operand, const TexturePoint& point,
                                        const Index& index) const noexcept {
    if (operand.texture < 0) return spectra_[operand.table].at(index);
    const auto evaluate = [&](const auto& node) noexcept -> ValuesAt<Index> {
        if constexpr (requires { node.image; }) {
            return colours_[static_cast<std::size_t>(node.image->space)]->reflectance(colour_of(node, point), index);
        } else if constexpr (requires { node.scale; }) {
            return value(node.texture, point, index) * value(node.scale, point);
        } else if constexpr (requires { node.amount; }) {
            const float amount = value(node.amount, point);
            return (1.0f - amount) * value(node.first, point, index) + amount * value(node.second, point, index);
        } else {
            return value(on_first_field(node.mapping, point) ? node.first : node.second, point, index);
        }
    };
    return visit_noexcept(evaluate, reflectances_[static_cast<std::size_t>(operand.texture)]);
}

template <class Index>
ValuesAt<Index> PreparedTextures::reflectance(TextureIndex texture, const TexturePoint& point,
                                              const Index& index) const noexcept {
    ValuesAt<Index> result = value(ReflectanceOperand{0, texture.index}, point, index);
    constexpr bool kSpectral = requires { index.cell; };
    constexpr float kLeast = kSpectral ? 0.0f : -1.0f;  // as SpectrumTables::prepare
    for (float& r : result.value) r = r > kLeast ? std::min(r, 1.0f) : kLeast;
    return result;
}

#define EMULSION_INSTANTIATE(TRANSPORT)                                                                  \
    template ValuesAt<TRANSPORT::Index> PreparedTextures::reflectance(TextureIndex, const TexturePoint&, \
                                                                      const TRANSPORT::Index&) const noexcept;
EMULSION_FOR_EACH_TRANSPORT(EMULSION_INSTANTIATE)

}  // namespace emulsion
