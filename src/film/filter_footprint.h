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
        const AxisTable& axis_table = table(axis);
        const Phase phase = axis_table.phase(place_px);
        const Cell& cell = axis_table.cells[phase.cell];
        if (cell.has_edge) [[unlikely]]
            return reach_from_edge_cell(axis_table, phase);
        return {phase.pixel + cell.reach.begin, phase.pixel + cell.reach.end};
    }

    /// Numbers of type float that weights() needs room for: the most pixels reached, rounded up to fours.
    [[nodiscard]] std::size_t room(FilterAxis axis) const noexcept { return table(axis).row; }

    /// The weights of the pixels reached; the first one's neighbours follow.
    struct Weights {
        Reach reached;
        const float* first = nullptr;
    };
    /// Puts them into `weights`, which must have room(axis). By cubics where these are the filter to 2e-6 of the mean
    /// weight; where they are not, within cells that hold an edge of the filter and for shapes narrower than a few
    /// cells, by the filter itself.
    [[nodiscard]] Weights weights(FilterAxis axis, float place_px, float* weights) const noexcept {
        const AxisTable& axis_table = table(axis);
        const Phase phase = axis_table.phase(place_px);
        const Cell& cell = axis_table.cells[phase.cell];
        if (cell.has_edge || !cell.has_cubics) [[unlikely]]
            return unusual_weights(axis, place_px, weights);
        axis_table.cubics(phase.cell, phase.t, weights);
        return {{phase.pixel + cell.reach.begin, phase.pixel + cell.reach.end}, weights};
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
    // Where a place is: its pixel, its cell there, and how far it is into both.
    struct Phase {
        int pixel = 0;
        std::size_t cell = 0;
        float in_pixel = 0.0f, t = 0.0f;  // in [0, 1)
    };
    struct Cell {
        Reach reach;              // from anywhere in the cell, if it is in pixel 0
        bool has_edge = false;    // from parts of it, less is reached
        bool has_cubics = false;  // or else they will not do there
    };
    // Of pixel cell.reach.begin + k, if the place is in pixel 0: c0 + t (c1 + t (c2 + t c3)). 4 row coefficients to a
    // cell, in blocks of four pixels: their c0, their c1, ...
    struct AxisTable {
        double radius_px = 0.0;
        double mean_weight_scale = 0.0;  // 2 radius / integral of f
        double mean_square_weight = 0.0;
        float cells_per_px = 0.0f;
        std::vector<Cell> cells;
        std::size_t row = 0;  // the most pixels that are reached from a cell, rounded up to fours
        std::vector<float> coefficients;

        [[nodiscard]] Phase phase(float place_px) const noexcept {
            // Below 0 the difference may round to 1.
            constexpr float kLast = 0x1.fffffep-1f;
            const float pixel = std::floor(place_px), in_pixel = std::min(place_px - pixel, kLast);
            const float scaled = in_pixel * cells_per_px, cell = std::floor(scaled);
            return {static_cast<int>(pixel), static_cast<std::size_t>(static_cast<int>(cell)), in_pixel, scaled - cell};
        }
        void cubics(std::size_t cell, float t, float* weights) const noexcept {
            using AnyFloat4 [[gnu::vector_size(16), gnu::aligned(4), gnu::may_alias]] = float;
            const std::size_t end = row;
            const float* c = coefficients.data() + cell * 4 * end;
            for (std::size_t i = 0; i < end; i += 4, c += 16) {
                const auto four = [c](int k) { return *reinterpret_cast<const AnyFloat4*>(c + 4 * k); };
                *reinterpret_cast<AnyFloat4*>(weights + i) = four(0) + t * (four(1) + t * (four(2) + t * four(3)));
            }
        }
    };

    [[nodiscard]] AxisTable make_table(FilterAxis axis) const;
    void add_cubics(AxisTable& table, FilterAxis axis, std::size_t cell) const;
    [[nodiscard]] const AxisTable& table(FilterAxis axis) const noexcept { return axis == FilterAxis::x ? x_ : y_; }
    [[nodiscard]] static Cell make_cell(double begin, double end, double radius) noexcept;
    [[nodiscard]] static Reach reach_in_pixel_0(double place, double radius) noexcept;
    [[nodiscard]] static Reach reach_from_edge_cell(const AxisTable& table, Phase phase) noexcept;
    [[nodiscard]] Weights unusual_weights(FilterAxis axis, float place_px, float* weights) const noexcept;

    Filter filter_;
    AxisTable x_, y_;
};

}  // namespace emulsion
