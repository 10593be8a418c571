#pragma once
// A rectangle of the film that one thread fills, without locks; BasicFilm::merge then adds it to the film.

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/color.h"
#include "core/image.h"
#include "film/dropped_samples.h"
#include "film/film_sums.h"
#include "film/sensor.h"
#include "spectrum/sampled_spectrum.h"

namespace emulsion {

/// Made by BasicFilm::make_tile. Pixels are named by their place in the film, not in the tile. Sums is one of FilmSums.
template <class Sums>
class BasicFilmTile {
  public:
    using Pixel = typename Sums::TilePixel;
    static constexpr std::uint32_t kMostSamples = 1u << 31;

    BasicFilmTile(PixelBounds bounds, std::shared_ptr<const Sensor> sensor);

    [[nodiscard]] const PixelBounds& bounds() const noexcept { return bounds_; }

    /// Adds one path's radiance, W m^-2 sr^-1 nm^-1, to the pixel (x, y), which must lie in bounds(). Dropped if the
    /// luminance of the light is negative; the XYZ that a camera or a white balance makes of it may be.
    template <int N>
    void add(int x, int y, const SampledWavelengths<N>& wavelengths, const SampledSpectrum<N>& radiance,
             float weight) noexcept {
        const SensorSample sample = sensor_->sense(wavelengths, radiance);
        accumulate(x, y, sample.xyz, sample.luminance, weight);
    }

    /// Adds a sample given as XYZ, Y in cd/m^2 (times the imaging ratio, if the film is to have one).
    /// Weights are signed, and of mean 1 if they come from a FilterSampler. A sample with a NaN, an infinity or a
    /// negative luminance is counted in dropped() and adds neither value nor weight.
    void add(int x, int y, XYZ value, float weight) noexcept { accumulate(x, y, value, value.y, weight); }

    /// Back to no samples, for the next use of the same bounds.
    void clear() noexcept;

    /// Row by row, bounds().width() to a row.
    [[nodiscard]] std::span<const Pixel> pixels() const noexcept { return pixels_; }
    /// The number of samples in each pixel, without the dropped ones; as many as pixels(). From kMostSamples on it is
    /// not exact, and the film takes the pixel for saturated.
    [[nodiscard]] std::span<const std::uint32_t> sample_counts() const noexcept { return sample_counts_; }
    [[nodiscard]] const DroppedSamples& dropped() const noexcept { return dropped_; }

  private:
    /// A sample that is judged by this luminance.
    void accumulate(int x, int y, XYZ value, float luminance, float weight) noexcept {
        const std::size_t i = index(x, y);
        // Products of floats cannot overflow a double: they are finite if, and only if, all four numbers are.
        const bool kept =
            luminance >= 0.0f && pixels_[i].add(static_cast<double>(value.x), static_cast<double>(value.y),
                                                static_cast<double>(value.z), static_cast<double>(weight));
        if (!kept) [[unlikely]]
            return drop(x, y, value, weight);
        if (++sample_counts_[i] % kCountsPerCarry == 0) [[unlikely]]
            carry(i);
    }

    [[nodiscard]] std::size_t index(int x, int y) const noexcept {
        assert(x >= bounds_.x0 && x < bounds_.x1 && y >= bounds_.y0 && y < bounds_.y1);
        return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(y) * width_ + x - first_);
    }
    /// Makes room in the sums and the count of a pixel.
    void carry(std::size_t i) noexcept;
    void drop(int x, int y, XYZ value, float weight) noexcept;

    static constexpr std::uint32_t kCountsPerCarry = 1u << 27;
    static_assert(kCountsPerCarry <= ExactTilePixel::kAddsPerCarry);

    PixelBounds bounds_;
    std::ptrdiff_t width_, first_;  // pixel (x, y) is y width_ + x - first_
    std::shared_ptr<const Sensor> sensor_;
    std::vector<Pixel> pixels_;
    std::vector<std::uint32_t> sample_counts_;
    DroppedSamples dropped_;
};

extern template class BasicFilmTile<ExactSums>;
extern template class BasicFilmTile<DoubleSums>;
extern template class BasicFilmTile<FloatSums>;
extern template class BasicFilmTile<KahanFloatSums>;

using FilmTile = BasicFilmTile<ExactSums>;

}  // namespace emulsion
