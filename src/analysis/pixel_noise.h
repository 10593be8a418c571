#pragma once
// How noisy the colour of a pixel is after some paths: because they bring different amounts of light, and because each
// carries a few wavelengths of all. Pictures of the pixel are drawn at random, from what is known of its light.
//
// A path brings either nothing or always the same, so that its variance is what it is said to be; its wavelengths don't
// depend on that. Where a path's light was dispersed, one of its wavelengths is left, with the weight of all.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/color.h"
#include "spectrum/spectrum.h"
#include "spectrum/viewing_conditions.h"
#include "spectrum/wavelength_sampler.h"

namespace emulsion {

/// Equal cells of the numbers in [0, 1) that wavelengths are drawn by.
inline constexpr std::size_t kNumberCells = 8192;

/// What one wavelength alone says of a colour, by its number: of the wavelengths that a strategy draws, in the light of
/// a scene. The mean of all cells is XYZ, however narrow the lines of the light are.
class WavelengthWeights {
  public:
    /// \throws std::invalid_argument as SpectrumTable does.
    WavelengthWeights(WavelengthSampler sampler, const Spectrum& light);

    /// For each of kNumberCells. Of the light times `ratio`, which is given at whole nanometres of the visible,
    /// straight lines between; the sum of their product with the observer is XYZ.
    [[nodiscard]] std::vector<XYZd> by_number(std::span<const double> ratio) const;
    [[nodiscard]] const WavelengthSampler& sampler() const noexcept { return sampler_; }

  private:
    struct Cell {
        std::size_t node = 0;  // between this nanometre and the next,
        double above = 0.0;    // this far
        XYZd weight{};         // light * observer / density
    };
    WavelengthSampler sampler_;
    std::vector<Cell> cells_;
};

/// What is known of a pixel.
struct PixelLight {
    XYZd xyz;                      ///< expected
    double path_variance = 0.0;    ///< of one path's luminance, in squares of its mean; >= 0
    double dispersed_share = 0.0;  ///< of the light; in [0, 1]
};

/// The paths that a pixel is made of.
struct PixelPaths {
    double count = 64.0;  ///< > 0
    /// Whether their numbers are spread evenly among them, each of a path's numbers by itself, as good samplers do.
    enum class Numbers { independent, even } numbers = Numbers::even;
};

/// Pictures that the mean is taken over, and the random numbers that they are drawn by.
struct NoiseDraws {
    int pictures = 16;  ///< >= 1
    std::uint64_t seed = 0;
};

/// Mean square CIEDE2000 of the pixel from what is expected, by paths that carry channels.
[[nodiscard]] double channel_noise(const PixelLight& light, const PixelPaths& paths, const ViewingConditions& viewing,
                                   const NoiseDraws& draws = {});

/// The same by paths of `wavelengths` (one of kWavelengthCounts) that `sampler` draws; `by_number` as WavelengthWeights
/// of that sampler has it.
[[nodiscard]] double wavelength_noise(const PixelLight& light, std::span<const XYZd> by_number,
                                      const WavelengthSampler& sampler, int wavelengths, const PixelPaths& paths,
                                      const ViewingConditions& viewing, const NoiseDraws& draws = {});

}  // namespace emulsion
