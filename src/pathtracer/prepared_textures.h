#pragma once
// A scene's textures, made ready to be looked up while rendering: nothing is allocated, nothing throws.

#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "pathtracer/scene_texture.h"
#include "pathtracer/texture_point.h"
#include "spectrum/sampled_spectrum.h"
#include "spectrum/sigmoid_table.h"
#include "spectrum/spectrum_table.h"

namespace emulsion {

/// Textures refer to textures of smaller index and are evaluated down to their constants. Calls nest as deep as the
/// textures do; most have constants only. The reader of scenes keeps what one evaluation may come to within bounds
/// (scene_textures.h).
class PreparedTextures {
  public:
    PreparedTextures() = default;
    /// Images are shared with the lists; the lists themselves are not kept.
    PreparedTextures(std::span<const FloatTexture> numbers, std::span<const ReflectanceTexture> reflectances);

    /// The value of Scene::float_textures[texture] at a point.
    [[nodiscard]] float number(TextureIndex texture, const TexturePoint& point) const noexcept;

    /// The value of Scene::reflectance_textures[texture] at a point and at the wavelengths of `index`, clamped to [0,
    /// 1]: scales above 1 may lead out of it.
    template <int N>
    [[nodiscard]] SampledSpectrum<N> reflectance(TextureIndex texture, const TexturePoint& point,
                                                 const SpectrumTableIndex<N>& index) const noexcept;

  private:
    // An operand is a constant if it has no texture.
    struct NumberOperand {
        float constant = 0.0f;
        std::int32_t texture = -1;
    };
    struct ReflectanceOperand {
        std::uint32_t table = 0;  // in constants_
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
        TextureMapping mapping;
    };
    template <class Operand, class Texel>
    using Node = std::variant<Scale<Operand>, Mix<Operand>, Checkerboard<Operand>, ImageTexture<Texel>>;

    [[nodiscard]] NumberOperand prepared(const FloatParameter& parameter);
    [[nodiscard]] ReflectanceOperand prepared(const ReflectanceParameter& parameter);
    template <class NodeType, class Texture>
    [[nodiscard]] NodeType prepared_node(const Texture& texture);

    [[nodiscard]] float value(const NumberOperand& operand, const TexturePoint& point) const noexcept;
    template <int N>
    [[nodiscard]] SampledSpectrum<N> value(const ReflectanceOperand& operand, const TexturePoint& point,
                                           const SpectrumTableIndex<N>& index) const noexcept;

    std::vector<Node<NumberOperand, float>> numbers_;
    std::vector<Node<ReflectanceOperand, RGB>> reflectances_;
    std::vector<SpectrumTable> constants_;
    std::optional<SigmoidTable> sigmoids_;  // of sRGB; if there are images of reflectances
};

}  // namespace emulsion
