#pragma once
// A rectangle of the film that one thread fills, without locks; Film::merge then adds it to the film.

#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/color.h"
#include "core/image.h"
#include "film/dropped_samples.h"
#include "film/sensor.h"
#include "spectrum/sampled_spectrum.h"

namespace emulsion {

/// Weighted sums over the samples of one pixel, in call order.
struct alignas(32) TilePixel {
    double x = 0.0, y = 0.0, z = 0.0;  ///< sum of weight * XYZ
    double weight = 0.0;               ///< sum of weights
};

/// Made by Film::make_tile. Pixels are named by their place in the film, not in the tile.
class FilmTile {
  public:
    FilmTile(PixelBounds bounds, std::shared_ptr<const Sensor> sensor);

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
    [[nodiscard]] std::span<const TilePixel> pixels() const noexcept { return pixels_; }
    /// The number of samples in each pixel, without the dropped ones; as many as pixels().
    [[nodiscard]] std::span<const std::uint32_t> sample_counts() const noexcept { return sample_counts_; }
    [[nodiscard]] const DroppedSamples& dropped() const noexcept { return dropped_; }

  private:
    /// A sample that is judged by this luminance.
    void accumulate(int x, int y, XYZ value, float luminance, float weight) noexcept {
        const std::size_t i = index(x, y);
        const auto w = static_cast<double>(weight);
        const double wx = w * static_cast<double>(value.x), wy = w * static_cast<double>(value.y),
                     wz = w * static_cast<double>(value.z);
        // Products of floats cannot overflow a double: the sum is finite if, and only if, all four numbers are.
        if (!(luminance >= 0.0f && std::isfinite((wx + wy) + (wz + w)))) {
            drop(x, y, value, weight);
            return;
        }
        TilePixel& pixel = pixels_[i];
        pixel.x += wx;
        pixel.y += wy;
        pixel.z += wz;
        pixel.weight += w;
        ++sample_counts_[i];
    }

    [[nodiscard]] std::size_t index(int x, int y) const noexcept {
        assert(x >= bounds_.x0 && x < bounds_.x1 && y >= bounds_.y0 && y < bounds_.y1);
        return static_cast<std::size_t>(y - bounds_.y0) * static_cast<std::size_t>(bounds_.width()) +
               static_cast<std::size_t>(x - bounds_.x0);
    }
    void drop(int x, int y, XYZ value, float weight) noexcept;

    PixelBounds bounds_;
    std::shared_ptr<const Sensor> sensor_;
    std::vector<TilePixel> pixels_;
    std::vector<std::uint32_t> sample_counts_;
    DroppedSamples dropped_;
};

}  // namespace emulsion
