#pragma once
// A scene's textures, made ready to be looked up while rendering: nothing is allocated, nothing throws.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "pathtracer/scene_texture.h"
#include "pathtracer/spectrum_tables.h"
#include "pathtracer/texel_colours.h"
#include "pathtracer/texture_point.h"
#include "pathtracer/transport.h"
#include "spectrum/sampled_spectrum.h"

namespace emulsion {

/// Textures refer to textures of smaller index and are evaluated down to their constants. Calls nest as deep as the
/// textures do; most have constants only. The reader of scenes keeps what one evaluation may come to within bounds
/// (scene_textures.h).
class PreparedTextures {
  public:
    /// Images are shared with the lists; the lists themselves are not kept. Adds the constants' spectra to `spectra`,
    /// and keeps a reference to it.
    PreparedTextures(std::span<const FloatTexture> numbers, std::span<const ReflectanceTexture> reflectances,
                     SpectrumTables& spectra);

    /// For paths of these channels; SpectrumTables::prepare() is the other half. \throws std::invalid_argument as that.
    void prepare(const FixedChannels& channels);

    /// The value of Scene::float_textures[texture] at a point.
    [[nodiscard]] float number(TextureIndex texture, const TexturePoint& point) const noexcept;

    /// The value of Scene::reflectance_textures[texture] at a point, for the channels of a transport's index, clamped
    /// to [0, 1], or fixed channels to [-1, 1]: scales above 1 may lead out of it.
    template <class Index>
    [[nodiscard]] ValuesAt<Index> reflectance(TextureIndex texture, const TexturePoint& point,
                                              const Index& index) const noexcept;

  private:
    // An operand is a constant if it has no texture.
    struct NumberOperand {
        float constant = 0.0f;
        std::int32_t texture = -1;
    };
    struct ReflectanceOperand {
        std::uint32_t table = 0;  // in spectra_
        std::int32_t texture = -1;
    };
    template <class Operand>
    struct Scale {
        Operand texture;
        NumberOperand scale;
    };
    template <class Operand>
    struct Mix {
        Operand first, second;
        NumberOperand amount;
    };
    template <class Operand>
    struct Checkerboard {
        Operand first, second;
        std::variant<TextureMapping, SolidTextureMapping> mapping;
    };
    template <class Operand, class Texel>
    using Node = std::variant<Scale<Operand>, Mix<Operand>, Checkerboard<Operand>, ImageTexture<Texel>>;

    [[nodiscard]] static NumberOperand prepared(const FloatParameter& parameter, SpectrumTables& spectra);
    [[nodiscard]] static ReflectanceOperand prepared(const ReflectanceParameter& parameter, SpectrumTables& spectra);
    template <class NodeType, class Texture>
    [[nodiscard]] static NodeType prepared_node(const Texture& texture, SpectrumTables& spectra);

    [[nodiscard]] float value(const NumberOperand& operand, const TexturePoint& point) const noexcept;
    template <class Index>
    [[nodiscard]] ValuesAt<Index> value(const ReflectanceOperand& operand, const TexturePoint& point,
                                        const Index& index) const noexcept;

    std::vector<Node<NumberOperand, float>> numbers_;
    std::vector<Node<ReflectanceOperand, RGB>> reflectances_;
    const SpectrumTables& spectra_;
    // By ColorSpace, of those that images of reflectances have.
    std::array<std::optional<TexelColours>, kColorSpaces> colours_;
};

}  // namespace emulsion
