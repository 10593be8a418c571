#pragma once
// The sums that a pixel has beside XYZ, weight and count, if the film's options ask for them: where each lies, and what
// holds them. All are exact, whatever the film's own sums are.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "film/exact_sum.h"
#include "film/film_options.h"

namespace emulsion {

/// For sums of weight * Y^2 and the like, Y in cd/m^2: multiples of 2^-60 = 8.7e-19 in (-2^67, 2^67) = 1.5e20, in 16
/// bytes. The square of 1e-6 cd/m^2 enters with an error of at most 4.4e-7 of itself; 2^67 is the sum of 1.4e8 samples
/// of 1e6 cd/m^2, or of 57 of the sun's disc (1.6e9 cd/m^2).
using SquareSum = FixedPointSum<128, 60>;

/// The places of a pixel's further sums: those of ExactSum in one row, those of SquareSum in another. A group that the
/// options leave out has size 0.
struct FilmChannels {
    struct Group {
        int begin = 0, size = 0;
        bool operator==(const Group&) const = default;
    };

    explicit FilmChannels(const FilmOptions& options);

    Group light_splat;       ///< X, Y, Z of light splats, over their area in pixels
    Group buckets;           ///< weight * radiance * coverage and weight * coverage of each spectral bucket, in turn
    Group bucket_splats;     ///< radiance * coverage of light splats in each bucket, over their area in pixels
    std::vector<Group> aux;  ///< of each layer: weight * components, then the weights
    Group means;             ///< of each group of MedianOfMeans: weight * X, Y, Z, and the weights
    /// For variances under a filter with negative lobes: weight^2 * Y, or weight^2 * X, Y, Z; then weight^2.
    Group squared_weights;
    int sums = 0;  ///< ExactSums to a pixel, all in all
    /// SquareSums to a pixel: weight * Y^2, or weight * X^2, Y^2, Z^2. With squared_weights, of weight^2.
    int squares = 0;
    bool operator==(const FilmChannels&) const = default;
};

/// The further sums of all pixels of a film or of a tile: pixel by pixel.
class ChannelSums {
  public:
    ChannelSums(const FilmChannels& channels, std::size_t pixels);

    [[nodiscard]] const FilmChannels& layout() const noexcept { return layout_; }

    [[nodiscard]] std::span<ExactSum> sums(std::size_t pixel) noexcept {
        return {sums_.data() + pixel * sums_per_pixel_, sums_per_pixel_};
    }
    [[nodiscard]] std::span<const ExactSum> sums(std::size_t pixel) const noexcept {
        return {sums_.data() + pixel * sums_per_pixel_, sums_per_pixel_};
    }
    [[nodiscard]] std::span<SquareSum> squares(std::size_t pixel) noexcept {
        return {squares_.data() + pixel * squares_per_pixel_, squares_per_pixel_};
    }
    [[nodiscard]] std::span<const SquareSum> squares(std::size_t pixel) const noexcept {
        return {squares_.data() + pixel * squares_per_pixel_, squares_per_pixel_};
    }

    /// Adds `count` pixels of another, from its pixel `from` on, to those from `to` on.
    void add(std::size_t to, const ChannelSums& other, std::size_t from, std::size_t count) noexcept;
    void clear() noexcept;
    /// One of the pixel's sums has left its range.
    [[nodiscard]] bool is_saturated(std::size_t pixel) const noexcept;

    /// All of them, as plain integers in memory: for files.
    [[nodiscard]] std::span<const ExactSum> all_sums() const noexcept { return sums_; }
    [[nodiscard]] std::span<ExactSum> all_sums() noexcept { return sums_; }
    [[nodiscard]] std::span<const SquareSum> all_squares() const noexcept { return squares_; }
    [[nodiscard]] std::span<SquareSum> all_squares() noexcept { return squares_; }
    bool operator==(const ChannelSums&) const = default;

  private:
    FilmChannels layout_;
    std::size_t sums_per_pixel_, squares_per_pixel_;
    std::vector<ExactSum> sums_;
    std::vector<SquareSum> squares_;
};

}  // namespace emulsion
