#pragma once
// Splatting: the pixels that a filter reaches from a place on the film, and their weights. Places are in pixels of the
// full frame; the centre of pixel i is at i + 0.5.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "core/image.h"
#include "film/filter.h"

namespace emulsion {

/// Weights have a mean of 1 over the support, so that sums of them are comparable to those of filter importance
/// sampling. The pixel i is reached from `place` if -radius < i + 0.5 - place <= radius: of the two pixels that a box
/// of half a pixel reaches from a corner, one has the sample. (At the radius itself the weight is the limit from
/// inside, which is 0 but for the box and, as good as, Blackman-Harris.)
class FilterFootprint {
  public:
    static constexpr int kCells = 512;
    static constexpr double kMostRadius_px = 65536.0;

    /// \throws std::invalid_argument as validate(Filter) does, and for a radius above kMostRadius_px.
    explicit FilterFootprint(const Filter& filter);

    /// Pixels [begin, end) of an axis; empty if end <= begin.
    struct Reach {
        int begin = 0, end = 0;
    };
    /// What is reached of the pixels [first, last). `place_px` must not be NaN.
    [[nodiscard]] Reach reach(FilterAxis axis, float place_px, int first, int last) const noexcept {
        const double radius = table(axis).radius_px, centre = static_cast<double>(place_px) - 0.5;
        const double begin = std::floor(centre - radius) + 1.0, end = std::floor(centre + radius) + 1.0;
        return {static_cast<int>(std::clamp(begin, static_cast<double>(first), static_cast<double>(last))),
                static_cast<int>(std::clamp(end, static_cast<double>(first), static_cast<double>(last)))};
    }

    /// The weights of the pixels [reach.begin, reach.end), which must be reached. By cubics in 512 cells where these
    /// are the filter to 2e-6 of the mean weight, which they are but for shapes narrower than a few cells.
    void weights(FilterAxis axis, float place_px, Reach reach, std::span<float> weights) const noexcept {
        const AxisTable& axis_table = table(axis);
        const auto place = static_cast<double>(place_px);
        for (int i = reach.begin; i < reach.end; ++i) {
            weights[static_cast<std::size_t>(i - reach.begin)] = weight(axis_table, axis, i + 0.5 - place);
        }
    }

    /// The same of one pixel, in double precision and with f evaluated at the place.
    [[nodiscard]] double weight_reference(FilterAxis axis, double offset_px) const noexcept;

    /// The area of the support: a weight over this is a density, of integral 1.
    [[nodiscard]] double area_px() const noexcept { return 4.0 * x_.radius_px * y_.radius_px; }
    /// Of a weight, over places drawn uniformly within reach; the mean of a weight is 1.
    [[nodiscard]] double mean_square_weight() const noexcept { return x_.mean_square_weight * y_.mean_square_weight; }
    /// The most pixels of an axis that are reached from one place.
    [[nodiscard]] std::size_t most_pixels(FilterAxis axis) const noexcept;

    /// The cells of places from which any of the pixels are reached.
    [[nodiscard]] PixelBounds places_that_reach(const PixelBounds& pixels) const noexcept;
    /// The pixels that are reached from places in [x0, x1] x [y0, y1].
    [[nodiscard]] PixelBounds reached_from(const PixelBounds& places) const noexcept;

  private:
    struct Cell {
        float w0, w1, w2, w3;
        bool is_cubic;  // false: no cubic is good enough
    };
    struct AxisTable {
        double radius_px = 0.0;
        double mean_weight_scale = 0.0;  // 2 radius / integral of f
        double mean_square_weight = 0.0;
        float cells_per_px = 0.0f;
        std::vector<Cell> cells;  // kCells, from the pixel's centre outwards
    };

    [[nodiscard]] static AxisTable make_table(const Filter& filter, FilterAxis axis);
    [[nodiscard]] const AxisTable& table(FilterAxis axis) const noexcept { return axis == FilterAxis::x ? x_ : y_; }
    [[nodiscard]] float weight(const AxisTable& axis_table, FilterAxis axis, double offset_px) const noexcept {
        const float scaled = static_cast<float>(std::abs(offset_px)) * axis_table.cells_per_px;
        const int index = std::min(static_cast<int>(scaled), kCells - 1);
        const float t = scaled - static_cast<float>(index);
        const Cell& cell = axis_table.cells[static_cast<std::size_t>(index)];
        if (!cell.is_cubic) [[unlikely]]
            return static_cast<float>(weight_reference(axis, offset_px));
        return cell.w0 + t * (cell.w1 + t * (cell.w2 + t * cell.w3));
    }

    Filter filter_;
    AxisTable x_, y_;
};

}  // namespace emulsion
