#pragma once
// The film: weighted samples in, scene-referred CIE XYZ out, Y in cd/m^2 (times the imaging ratio).
// Threads fill tiles of their own and merge them. The pixels' sums are exact: every sample is rounded once, on its own,
// as it enters a tile, and nothing is rounded after that. So the picture is bit-identical for every order of samples
// and merges, every number of threads, every size of tiles, and every way of sharing samples out over runs and
// machines.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "core/color.h"
#include "core/image.h"
#include "film/dropped_samples.h"
#include "film/film_contents.h"
#include "film/film_counts.h"
#include "film/film_options.h"
#include "film/film_setup.h"
#include "film/film_sums.h"
#include "film/film_tile.h"
#include "film/pixel_values.h"
#include "film/sensor.h"

namespace emulsion {

/// Sums is one of FilmSums; what is said of bits holds for ExactSums. Film, below, is the film of them.
template <class Sums>
class BasicFilm {
  public:
    /// An empty film. \throws std::invalid_argument as validate(FilmOptions) and Sensor do.
    explicit BasicFilm(const FilmOptions& options);
    /// A film that goes on from what another of the same options has gathered.
    /// \throws std::invalid_argument also if the contents are of another size.
    BasicFilm(const FilmOptions& options, FilmContents<Sums> contents);
    ~BasicFilm() = default;
    BasicFilm(const BasicFilm&) = delete;
    BasicFilm& operator=(const BasicFilm&) = delete;

    [[nodiscard]] const FilmOptions& options() const noexcept { return setup_->options; }
    [[nodiscard]] const Sensor& sensor() const noexcept { return setup_->sensor; }
    [[nodiscard]] const FilmSetup& setup() const noexcept { return *setup_; }
    /// The film's pixels, in coordinates of the full frame: the crop window, if there is one.
    [[nodiscard]] const PixelBounds& bounds() const noexcept { return setup_->bounds; }
    /// The pixels to send samples to: bounds(), and a border more if the film splats. It may leave the frame.
    [[nodiscard]] const PixelBounds& sample_bounds() const noexcept { return setup_->sample_bounds; }

    /// An empty tile for samples within `places`. Tiles may overlap, may outlive the film, and any number may exist.
    /// \throws std::invalid_argument unless `places` has pixels and lies inside sample_bounds().
    [[nodiscard]] BasicFilmTile<Sums> make_tile(PixelBounds places) const;

    /// Adds a tile's sums to the film; the tile is left as it is, and merged twice it counts twice. Thread-safe.
    /// The result does not depend on any order unless a sum saturates (saturated_pixels()).
    /// \throws std::invalid_argument if the tile does not lie inside the film, or is one of a film with other options.
    void merge(const BasicFilmTile<Sums>& tile);

    /// Adds what another film of the same options has gathered. Thread-safe.
    /// \throws std::invalid_argument if the options differ, and for the film itself.
    void merge(const BasicFilm& other);

    /// The paths that a light tracer has traced, those that sent nothing among them: light splats are over their sum.
    void add_light_paths(std::uint64_t paths);

    /// sum(weight XYZ) / sum(weight) of each pixel, or the median of means, and the light splats over the number of
    /// light paths; 0 for pixels without a value, see pixels_without_value(). The size is that of bounds().
    /// \throws std::logic_error if there are light splats and the number of light paths is 0.
    [[nodiscard]] Image<XYZ> xyz_image() const;

    /// Pixels whose weight sum is below kMinMeanWeight * their number of samples, or that have no samples. None if the
    /// film has light splats only.
    [[nodiscard]] std::int64_t pixels_without_value() const;
    /// Pixels with a sum that has left its range, or with more than 2^32 - 2 samples: their value is wrong, and finite
    /// if the sums are exact.
    [[nodiscard]] std::int64_t saturated_pixels() const;

    /// What was counted beside the pixels: samples, dropped samples, light paths.
    [[nodiscard]] FilmCounts counts() const;
    /// What was kept out of the tiles merged so far.
    [[nodiscard]] DroppedSamples dropped() const { return counts().dropped; }
    /// Samples that were added, each counted once; without the dropped ones.
    [[nodiscard]] std::uint64_t sample_count() const { return counts().samples; }
    /// Samples that reach the pixel with the fewest and the one with the most; without the dropped ones.
    [[nodiscard]] std::uint64_t min_samples_per_pixel() const;
    [[nodiscard]] std::uint64_t max_samples_per_pixel() const;

    /// A copy of everything, consistent even while others merge.
    [[nodiscard]] FilmContents<Sums> contents() const;

    /// visit(const FilmContents<Sums>&), while merges wait: everything at one moment, without a copy.
    template <class Visit>
    decltype(auto) with_contents(const Visit& visit) const {
        const std::lock_guard lock(mutex_);
        return visit(contents_);
    }
    /// Calls visit(pixel number, PixelSums) for every pixel, row by row, while merges wait.
    template <class Visit>
    void for_each_pixel(const Visit& visit) const {
        const std::lock_guard lock(mutex_);
        for (std::size_t i = 0; i < contents_.pixels.size(); ++i) visit(i, sums_of(contents_, i));
    }

  private:
    std::shared_ptr<const FilmSetup> setup_;
    mutable std::mutex mutex_;  // guards all below
    FilmContents<Sums> contents_;
};

extern template class BasicFilm<ExactSums>;
extern template class BasicFilm<DoubleSums>;
extern template class BasicFilm<FloatSums>;
extern template class BasicFilm<KahanFloatSums>;

using Film = BasicFilm<ExactSums>;

}  // namespace emulsion
