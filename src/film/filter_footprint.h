#pragma once
// Splatting: the pixels that a filter reaches from a place on the film, and their weights. Places are in pixels of the
// full frame; the centre of pixel i is at i + 0.5.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

#include "core/image.h"
#include "film/filter.h"
#include "film/vectors.h"

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

    /// 4 x 4 pixels, and their weights along both axes in registers.
    struct FourByFour {
        int x_px = 0, y_px = 0;  ///< the first pixel
        Float4 x_weights{}, y_weights{};
    };
    /// What is reached from a place, which must be within 2^22 pixels of 0, where that is 4 x 4 pixels and can be had
    /// quickly: from all places in pixels from 0 on, under most filters of radius 2. The bits are those of weights().
    [[nodiscard]] std::optional<FourByFour> four_by_four(float x_px, float y_px) const noexcept {
        // Cells are counted from place 0. All of it is exact: there is a power of two of cells to a pixel.
        const Float4 scaled = Float4{x_px, y_px, 0.0f, 0.0f} * cells_per_px_;
        const Int4 cells = __builtin_convertvector(scaled, Int4);
        const Float4 t = scaled - __builtin_convertvector(cells, Float4);
        const auto of_axis = scalars(std::bit_cast<Uint4>(cells));
        const std::size_t x_cell = of_axis[0] & x_.cell_mask, y_cell = of_axis[1] & y_.cell_mask;
        const Cell &x = x_.cells[x_cell], &y = y_.cells[y_cell];
        if (!x.is_quick_four || !y.is_quick_four || !(x_px >= 0.0f) || !(y_px >= 0.0f)) return std::nullopt;
        return FourByFour{static_cast<int>(of_axis[0] >> x_.cell_bits) + x.reach.begin,
                          static_cast<int>(of_axis[1] >> y_.cell_bits) + y.reach.begin,
                          cubics_of_four(x_.coefficients.data() + 16 * x_cell, broadcast<0>(t)),
                          cubics_of_four(y_.coefficients.data() + 16 * y_cell, broadcast<1>(t))};
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
        Reach reach;                 // from anywhere in the cell, if it is in pixel 0
        bool has_edge = false;       // from parts of it, less is reached
        bool has_cubics = false;     // or else they will not do there
        bool is_quick_four = false;  // for four_by_four()
    };

    /// The weights of four pixels, from their 16 coefficients.
    [[nodiscard]] static Float4 cubics_of_four(const float* c, Float4 t) noexcept {
        using AnyFloat4 [[gnu::vector_size(16), gnu::aligned(4), gnu::may_alias]] = float;
        const auto four = [c](int k) -> Float4 { return *reinterpret_cast<const AnyFloat4*>(c + 4 * k); };
        return four(0) + t * (four(1) + t * (four(2) + t * four(3)));
    }

    // Of pixel cell.reach.begin + k, if the place is in pixel 0: c0 + t (c1 + t (c2 + t c3)). 4 row coefficients to a
    // cell, in blocks of four pixels: their c0, their c1, ...
    struct AxisTable {
        double radius_px = 0.0;
        double mean_weight_scale = 0.0;  // 2 radius / integral of f
        double mean_square_weight = 0.0;
        float cells_per_px = 0.0f;
        std::uint32_t cell_bits = 0, cell_mask = 0;  // 2^cell_bits cells to a pixel; 0 if it is no power of two
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
            const float* c = coefficients.data() + cell * 4 * row;
            for (std::size_t i = 0; i < row; i += 4, c += 16) {
                const Float4 four = cubics_of_four(c, Float4{t, t, t, t});
                std::memcpy(weights + i, &four, sizeof four);
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
    Float4 cells_per_px_{};  // x's and y's
};

}  // namespace emulsion
