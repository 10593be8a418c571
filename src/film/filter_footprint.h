#pragma once
// Splatting: the pixels that a filter reaches from a place on the film, and their weights. Places are in pixels of the
// full frame; the centre of pixel i is at i + 0.5.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/image.h"
#include "film/filter.h"

namespace emulsion {

/// Weights have a mean of 1 over the support, so that sums of them are comparable to those of filter importance
/// sampling. The pixel i is reached from `place` if -radius < i + 0.5 - place <= radius: of the two pixels that a box
/// of half a pixel reaches from a corner, one has the sample. (At the radius itself the weight is the limit from
/// inside, which is 0 but for the box and, as good as, Blackman-Harris.)
///
/// Pixels are one apart, so that the place within its pixel decides all weights of an axis. It is looked up in cells,
/// for each of which every pixel has a cubic: all weights for the price of one.
class FilterFootprint {
  public:
    static constexpr double kMostRadius_px = 65536.0;

    /// \throws std::invalid_argument as validate(Filter) does, and for a radius above kMostRadius_px.
    explicit FilterFootprint(const Filter& filter);

    /// Pixels [begin, end) of an axis; empty if end <= begin.
    struct Reach {
        int begin = 0, end = 0;
    };
    /// What is reached from a place, which must be within 2^22 pixels of 0.
    [[nodiscard]] Reach reach(FilterAxis axis, float place_px) const noexcept {
        const double radius = table(axis).radius_px, centre = static_cast<double>(place_px) - 0.5;
        return {static_cast<int>(std::floor(centre - radius)) + 1, static_cast<int>(std::floor(centre + radius)) + 1};
    }

    /// Numbers of type float that weights() needs room for: the most pixels of an axis, rounded up to fours.
    [[nodiscard]] std::size_t room(FilterAxis axis) const noexcept { return table(axis).row; }

    /// Puts the weights of the pixels reached into `weights`, which must have room(axis), and returns the first: its
    /// neighbours follow. By cubics where these are the filter to 2e-6 of the mean weight; where they are not, within
    /// cells that hold an edge of the filter and for shapes narrower than a few cells, by the filter itself.
    [[nodiscard]] const float* weights(FilterAxis axis, float place_px, Reach reached, float* weights) const noexcept {
        const AxisTable& axis_table = table(axis);
        const float pixel = std::floor(place_px);
        const float scaled = (place_px - pixel) * axis_table.cells_per_px;
        const int index = std::min(static_cast<int>(scaled), axis_table.last_cell);
        const float t = scaled - static_cast<float>(index);
        const float* const c = axis_table.coefficients.data() + static_cast<std::size_t>(index) * 4 * axis_table.row;
        for (std::size_t i = 0; i < axis_table.row; i += 4) four_cubics(c + 4 * i, t, weights + i);
        if (std::isnan(weights[0])) [[unlikely]]
            return weights_by_reference(axis, place_px, reached, weights);
        return weights + (reached.begin - static_cast<int>(pixel) - axis_table.first);
    }

    /// One of them, in double precision and with f evaluated at the place.
    [[nodiscard]] double weight_reference(FilterAxis axis, double offset_px) const noexcept;

    /// The area of the support: a weight over this is a density, of integral 1.
    [[nodiscard]] double area_px() const noexcept { return 4.0 * x_.radius_px * y_.radius_px; }
    /// Of a weight, over places drawn uniformly within reach; the mean of a weight is 1.
    [[nodiscard]] double mean_square_weight() const noexcept { return x_.mean_square_weight * y_.mean_square_weight; }

    /// The cells of places from which any of the pixels are reached.
    [[nodiscard]] PixelBounds places_that_reach(const PixelBounds& pixels) const noexcept;
    /// The pixels that are reached from places in [x0, x1] x [y0, y1].
    [[nodiscard]] PixelBounds reached_from(const PixelBounds& places) const noexcept;

  private:
    // Of pixel first + k, if the place is in pixel 0 and at t in [0, 1] within its cell: c0 + t (c1 + t (c2 + t c3)).
    // 4 row coefficients to a cell, in blocks of four pixels: their c0, their c1, ... The first c0 of a cell is NaN if
    // cubics will not do there.
    struct AxisTable {
        double radius_px = 0.0;
        double mean_weight_scale = 0.0;  // 2 radius / integral of f
        double mean_square_weight = 0.0;
        float cells_per_px = 0.0f;
        int last_cell = 0;
        int first = 0;        // the first pixel that is reached from anywhere in pixel 0
        std::size_t row = 0;  // pixels that are, rounded up to fours
        std::vector<float> coefficients;
    };

    static void four_cubics(const float* c, float t, float* weights) noexcept {
        using AnyFloat4 [[gnu::vector_size(16), gnu::aligned(4), gnu::may_alias]] = float;
        const auto four = [c](int i) { return *reinterpret_cast<const AnyFloat4*>(c + 4 * i); };
        *reinterpret_cast<AnyFloat4*>(weights) = four(0) + t * (four(1) + t * (four(2) + t * four(3)));
    }

    [[nodiscard]] AxisTable make_table(FilterAxis axis) const;
    void add_cell(AxisTable& table, FilterAxis axis, double begin, double width) const;
    [[nodiscard]] const AxisTable& table(FilterAxis axis) const noexcept { return axis == FilterAxis::x ? x_ : y_; }
    [[nodiscard]] const float* weights_by_reference(FilterAxis axis, float place_px, Reach reached,
                                                    float* weights) const noexcept;

    Filter filter_;
    AxisTable x_, y_;
};

}  // namespace emulsion
