#pragma once
// The exact sums of one pixel of the film: 48 bytes of plain integers, which anybody may add up.

#include <cstdint>

#include "film/exact_sum.h"
#include "film/exact_tile_pixel.h"
#include "film/weighted_sums.h"

namespace emulsion {

class ExactFilmPixel {
  public:
    void add(const ExactTilePixel& tile, std::uint32_t samples) noexcept {
        x_.add_units(tile.x_units());
        y_.add_units(tile.y_units());
        z_.add_units(tile.z_units());
        weight_.add_units(tile.weight_units());
        samples_.add(samples);
    }
    void merge(const ExactFilmPixel& other) noexcept {
        x_ += other.x_;
        y_ += other.y_;
        z_ += other.z_;
        weight_ += other.weight_;
        samples_.add(other.samples());
    }

    [[nodiscard]] WeightedSums sums() const noexcept { return {{x_.value(), y_.value(), z_.value()}, weight_.value()}; }
    [[nodiscard]] std::uint32_t samples() const noexcept { return samples_.count(); }
    /// A sum or the count has left its range.
    [[nodiscard]] bool is_saturated() const noexcept {
        return x_.is_saturated() || y_.is_saturated() || z_.is_saturated() || weight_.is_saturated() ||
               samples_.is_saturated();
    }
    bool operator==(const ExactFilmPixel&) const = default;

  private:
    ExactSum x_, y_, z_;
    ExactWeightSum weight_;
    SampleCount samples_;
};

static_assert(sizeof(ExactFilmPixel) == 48);

}  // namespace emulsion
