#pragma once
// The film: weighted samples in, scene-referred CIE XYZ out, Y in cd/m^2 (times the imaging ratio).
// Threads fill tiles of their own and merge them; the pixels' sums are exact, so that the picture is bit-identical for
// every order of merges, and so for every number of threads.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "core/color.h"
#include "core/image.h"
#include "film/dropped_samples.h"
#include "film/exact_sum.h"
#include "film/film_tile.h"
#include "film/sensor.h"

namespace emulsion {

struct FilmOptions {
    int width_px = 1280;        ///< in [1, 65536]
    int height_px = 720;        ///< in [1, 65536]
    SensorOptions sensor = {};  ///< applied to spectral samples
    bool operator==(const FilmOptions&) const = default;
};

/// \throws std::invalid_argument naming the field, its value and its range.
void validate(const FilmOptions& options);

/// A pixel whose weights have a mean below this has no value. The weights of filters with negative lobes can cancel;
/// a quotient by such a sum is noise, magnified more than 1 / kMinMeanWeight = 64 times.
inline constexpr double kMinMeanWeight = 1.0 / 64.0;

class Film {
  public:
    /// \throws std::invalid_argument as validate() does.
    explicit Film(const FilmOptions& options);
    ~Film() = default;
    Film(const Film&) = delete;
    Film& operator=(const Film&) = delete;

    [[nodiscard]] const FilmOptions& options() const noexcept { return options_; }
    [[nodiscard]] const Sensor& sensor() const noexcept { return *sensor_; }
    /// The whole picture.
    [[nodiscard]] PixelBounds bounds() const noexcept { return {0, 0, options_.width_px, options_.height_px}; }

    /// An empty tile. Tiles may overlap, may outlive the film, and any number may exist.
    /// \throws std::invalid_argument unless the bounds are not empty and lie inside the film.
    [[nodiscard]] FilmTile make_tile(PixelBounds bounds) const;

    /// Adds a tile's sums to the film; the tile is left as it is, and merged twice it counts twice. Thread-safe.
    /// Each sum is converted once to ExactSum: the result depends on the order of the samples within a tile, and not on
    /// the order of merges, unless a sum saturates (saturated_pixels()).
    /// \throws std::invalid_argument if the tile's bounds do not lie inside the film.
    void merge(const FilmTile& tile);

    /// sum(weight XYZ) / sum(weight) of each pixel; 0 for pixels without a value, see pixels_without_value().
    [[nodiscard]] Image<XYZ> xyz_image() const;

    /// Pixels whose weight sum is below kMinMeanWeight * their number of samples, or that have no samples.
    [[nodiscard]] std::int64_t pixels_without_value() const;
    /// Pixels with a sum that has left the range of ExactSum; their value is finite and wrong.
    [[nodiscard]] std::int64_t saturated_pixels() const;

    /// What was kept out of the tiles merged so far.
    [[nodiscard]] DroppedSamples dropped() const;
    /// Samples in all pixels, in the pixel with the fewest and in the one with the most; without the dropped ones.
    [[nodiscard]] std::uint64_t sample_count() const;
    [[nodiscard]] std::uint64_t min_samples_per_pixel() const;
    [[nodiscard]] std::uint64_t max_samples_per_pixel() const;

  private:
    struct Pixel {
        ExactSum x, y, z;  // sums of weight * XYZ
        ExactSum weight;
    };
    [[nodiscard]] bool has_value(std::size_t i) const noexcept;

    FilmOptions options_;
    std::shared_ptr<const Sensor> sensor_;
    mutable std::mutex mutex_;  // guards all below
    std::vector<Pixel> pixels_;
    std::vector<std::uint64_t> sample_counts_;
    DroppedSamples dropped_;
};

}  // namespace emulsion
