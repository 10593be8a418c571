#pragma once
// Texels of linear RGB as values of a path's channels: nothing is allocated, nothing throws.

#include <array>

#include "core/color.h"
#include "pathtracer/scene_color_space.h"
#include "pathtracer/transport.h"
#include "spectrum/sigmoid_table.h"

namespace emulsion {

/// Of one space.
class TexelColours {
  public:
    explicit TexelColours(ColorSpace space);

    /// Clamped to [0, 1].
    template <int N>
    [[nodiscard]] SampledSpectrum<N> reflectance(const RGB& texel, const SpectrumTableIndex<N>& index) const noexcept {
        return eval<N>(sigmoids_.reflectance(texel), wavelengths_of(index));
    }
    /// Of colours that sRGB doesn't have, outside of [0, 1].
    [[nodiscard]] SampledSpectrum<3> reflectance(const RGB& texel, const RgbTransport::Index&) const noexcept {
        return in_srgb(texel);
    }

    /// What the space's illuminant is to be multiplied by.
    template <int N>
    [[nodiscard]] SampledSpectrum<N> light(const RGB& texel, const SpectrumTableIndex<N>& index) const noexcept {
        const ScaledSigmoid colour = sigmoids_.unbounded(texel);
        return eval<N>(colour.sigmoid, wavelengths_of(index)) * colour.scale;
    }
    [[nodiscard]] SampledSpectrum<3> light(const RGB& texel, const RgbTransport::Index&) const noexcept {
        return in_srgb(texel);
    }

  private:
    template <int N>
    [[nodiscard]] static std::array<float, N> wavelengths_of(const SpectrumTableIndex<N>& index) noexcept {
        std::array<float, N> lambda_nm{};
        for (std::size_t i = 0; i < N; ++i) {
            lambda_nm[i] = static_cast<float>(kMinWavelength_nm + index.cell[i]) + index.fraction[i];
        }
        return lambda_nm;
    }
    [[nodiscard]] SampledSpectrum<3> in_srgb(const RGB& texel) const noexcept;

    SigmoidTable sigmoids_;
    bool is_srgb_;
    std::array<std::array<float, 3>, 3> srgb_from_{};  // rows
};

}  // namespace emulsion
