#pragma once
// The film: weighted samples in, scene-referred CIE XYZ out, Y in cd/m^2 (times the imaging ratio).
// Threads fill tiles of their own and merge them. The pixels' sums are exact: every sample is rounded once, on its own,
// as it enters a tile, and nothing is rounded after that. So the picture is bit-identical for every order of samples
// and merges, every number of threads, every size of tiles, and every way of sharing samples out over runs and
// machines.

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "core/color.h"
#include "core/image.h"
#include "film/dropped_samples.h"
#include "film/film_sums.h"
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

/// Sums is one of FilmSums; what is said of bits holds for ExactSums. Film, below, is the film of them.
template <class Sums>
class BasicFilm {
  public:
    /// \throws std::invalid_argument as validate() does.
    explicit BasicFilm(const FilmOptions& options);
    ~BasicFilm() = default;
    BasicFilm(const BasicFilm&) = delete;
    BasicFilm& operator=(const BasicFilm&) = delete;

    [[nodiscard]] const FilmOptions& options() const noexcept { return options_; }
    [[nodiscard]] const Sensor& sensor() const noexcept { return *sensor_; }
    /// The whole picture.
    [[nodiscard]] PixelBounds bounds() const noexcept { return {0, 0, options_.width_px, options_.height_px}; }

    /// An empty tile. Tiles may overlap, may outlive the film, and any number may exist.
    /// \throws std::invalid_argument unless the bounds are not empty and lie inside the film.
    [[nodiscard]] BasicFilmTile<Sums> make_tile(PixelBounds bounds) const;

    /// Adds a tile's sums to the film; the tile is left as it is, and merged twice it counts twice. Thread-safe.
    /// The result does not depend on any order unless a sum saturates (saturated_pixels()).
    /// \throws std::invalid_argument if the tile's bounds do not lie inside the film.
    void merge(const BasicFilmTile<Sums>& tile);

    /// sum(weight XYZ) / sum(weight) of each pixel; 0 for pixels without a value, see pixels_without_value().
    [[nodiscard]] Image<XYZ> xyz_image() const;

    /// Pixels whose weight sum is below kMinMeanWeight * their number of samples, or that have no samples.
    [[nodiscard]] std::int64_t pixels_without_value() const;
    /// Pixels with a sum that has left its range, or with more than 2^32 - 2 samples: their value is wrong, and finite
    /// if the sums are exact.
    [[nodiscard]] std::int64_t saturated_pixels() const;

    /// What was kept out of the tiles merged so far.
    [[nodiscard]] DroppedSamples dropped() const;
    /// Samples in all pixels, in the pixel with the fewest and in the one with the most; without the dropped ones.
    [[nodiscard]] std::uint64_t sample_count() const;
    [[nodiscard]] std::uint64_t min_samples_per_pixel() const;
    [[nodiscard]] std::uint64_t max_samples_per_pixel() const;

  private:
    using Pixel = typename Sums::FilmPixel;

    FilmOptions options_;
    std::shared_ptr<const Sensor> sensor_;
    mutable std::mutex mutex_;  // guards all below
    std::vector<Pixel> pixels_;
    DroppedSamples dropped_;
};

extern template class BasicFilm<ExactSums>;
extern template class BasicFilm<DoubleSums>;
extern template class BasicFilm<FloatSums>;
extern template class BasicFilm<KahanFloatSums>;

using Film = BasicFilm<ExactSums>;

}  // namespace emulsion
