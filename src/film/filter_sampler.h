#pragma once
// Filter importance sampling: the sample's place in the pixel is drawn from the filter, and the sample then belongs to
// that one pixel with a signed weight. Same expected picture as splatting every sample into every pixel it reaches.
// Source: Ernst, Stamminger & Greiner, "Filter Importance Sampling", IEEE Symposium on Interactive Ray Tracing 2006.

#include <cstddef>
#include <vector>

#include "film/filter.h"

namespace emulsion {

/// Where a sample lies, and what it counts for.
struct FilterSample {
    float x_offset_px = 0.0f;  ///< from the pixel's centre, to the right; in [-radius, radius]
    float y_offset_px = 0.0f;  ///< from the pixel's centre, downwards; in [-radius, radius]
    float weight = 1.0f;       ///< f/pdf, of mean 1; negative in the filter's negative lobes
};

/// Draws positions with a density close to |f|: along each half-axis, kCells cells of equal probability, each of
/// constant density, so that the inverse of the distribution is one look-up and keeps the stratification of its input.
/// The weight is f itself over that density, and not a constant, so that expectations do not depend on the number of
/// cells. For a box the inverse is exact and the weight always 1.
class FilterSampler {
  public:
    static constexpr int kCells = 512;

    /// \throws std::invalid_argument as validate() does, and if the filter's integral along an axis is not positive:
    /// it could not be normalised.
    explicit FilterSampler(const Filter& filter);

    /// u and v in [0, 1): two uniform numbers, for x and for y. Within a cell f is a cubic through four of its points:
    /// the weight agrees with weight_reference() to 1e-5 root mean square, and its mean to 1e-6.
    [[nodiscard]] FilterSample sample(float u, float v) const noexcept;

    /// f/pdf at a position, f evaluated there, in double precision.
    [[nodiscard]] double weight_reference(double x_offset_px, double y_offset_px) const noexcept;

    /// Density of x_offset_px (or y), 1/px: constant within a cell, 0 past the radius.
    [[nodiscard]] double pdf(FilterAxis axis, double offset_px) const noexcept;

  private:
    // Offset start + t width and weight w0 + t (w1 + t (w2 + t w3)), for t in [0, 1] from the pixel's centre outwards.
    struct Cell {
        float start_px, width_px, w0, w1, w2, w3;
    };
    // One half-axis; the other is its mirror image.
    struct AxisTable {
        std::vector<double> edge_px;  // kCells + 1, from 0 to the radius
        std::vector<Cell> cells;      // kCells
        double integral_px = 0.0;     // of f over the whole axis, with its sign
    };
    struct AxisSample {
        float offset_px, weight;
    };

    [[nodiscard]] static AxisTable make_table(const Filter& filter, FilterAxis axis);
    [[nodiscard]] static AxisSample sample_axis(const AxisTable& table, float u) noexcept;
    [[nodiscard]] double weight_along(FilterAxis axis, double offset_px) const noexcept;

    Filter filter_;
    AxisTable x_, y_;
};

}  // namespace emulsion
