#pragma once
// Texels of linear RGB as values of a path's channels: nothing is allocated, nothing throws.

#include <array>
#include <optional>

#include "core/color.h"
#include "pathtracer/channel_colours.h"
#include "pathtracer/scene_color_space.h"
#include "pathtracer/transport.h"
#include "spectrum/sigmoid_table.h"

namespace emulsion {

/// Of one space.
class TexelColours {
  public:
    explicit TexelColours(ColorSpace space) : space_(space), sigmoids_(rgb_space_of(space)) {}

    /// For paths of these channels: texels as reflectances, or as colours of a light.
    /// \throws std::invalid_argument as ChannelColours.
    void prepare(const FixedChannels& channels) { channels_.emplace(channels, rgb_space_of(space_), sigmoids_); }
    void prepare(const FixedChannels& channels, const Spectrum& light) {
        channels_.emplace(channels, rgb_space_of(space_), sigmoids_, light);
    }

    /// Clamped to [0, 1].
    template <int N>
    [[nodiscard]] SampledSpectrum<N> reflectance(const RGB& texel, const SpectrumTableIndex<N>& index) const noexcept {
        return eval<N>(sigmoids_.reflectance(texel), wavelengths_of(index));
    }
    /// Where channels are colours, of colours that they don't have outside of [0, 1].
    template <int K>
    [[nodiscard]] SampledSpectrum<K> reflectance(const RGB& texel, const FixedIndex<K>& /*index*/) const noexcept {
        return channels_->at<K>(texel);
    }

    /// What the space's illuminant is to be multiplied by.
    template <int N>
    [[nodiscard]] SampledSpectrum<N> light(const RGB& texel, const SpectrumTableIndex<N>& index) const noexcept {
        const ScaledSigmoid colour = sigmoids_.unbounded(texel);
        return eval<N>(colour.sigmoid, wavelengths_of(index)) * colour.scale;
    }
    template <int K>
    [[nodiscard]] SampledSpectrum<K> light(const RGB& texel, const FixedIndex<K>& /*index*/) const noexcept {
        return channels_->unbounded<K>(texel);
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

    ColorSpace space_;
    SigmoidTable sigmoids_;
    std::optional<ChannelColours> channels_;  // once these are known
};

}  // namespace emulsion
