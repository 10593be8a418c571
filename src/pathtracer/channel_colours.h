#pragma once
// RGB colours of pictures as channels, where rendering meets millions of them.
//
// For channels that are linear colours it is a matrix, as RGB renderers mix RGB, and white is white. For others it is
// what the spectrum of the colour gives (spectrum/sigmoid_table.h), interpolated from a grid of colours: beside the
// best matrix only what differs from it is, which is small.

#include <array>
#include <vector>

#include "core/color.h"
#include "pathtracer/fixed_channels.h"
#include "spectrum/rgb_space.h"
#include "spectrum/sampled_spectrum.h"
#include "spectrum/sigmoid_table.h"

namespace emulsion {

class ChannelColours {
  public:
    /// Reflectances. `sigmoids` is the table of `space`.
    /// \throws std::invalid_argument as property_values() does.
    ChannelColours(const FixedChannels& channels, const RgbSpace& space, const SigmoidTable& sigmoids);

    /// Colours of a light: what light_values() of `light` are multiplied by.
    ChannelColours(const FixedChannels& channels, const RgbSpace& space, const SigmoidTable& sigmoids,
                   const Spectrum& light);

    /// K is compiled_channels() of theirs. Components of the colour outside [0, 1] are taken for the nearer of the two,
    /// unless all channels are colours themselves.
    template <int K>
    [[nodiscard]] SampledSpectrum<K> at(const RGB& rgb) const noexcept;

    /// The same of a colour without an upper bound, as SigmoidTable::unbounded has it.
    template <int K>
    [[nodiscard]] SampledSpectrum<K> unbounded(const RGB& rgb) const noexcept;

  private:
    /// Weights at whole nanometres of the channels that are no colours, empty for those that are.
    using Weights = std::vector<std::vector<double>>;
    void fill(const FixedChannels& channels, const RgbSpace& space, const Weights& weights,
              const SigmoidTable& sigmoids);

    using Column = std::array<float, kMostFixedChannels>;
    std::array<Column, 3> of_primary_{};  // the matrix
    std::size_t stride_ = 0;              // channels of a colour of the grid
    std::vector<float> grid_;             // kSide^3 differences from the matrix, red fastest; empty: none
};

}  // namespace emulsion
