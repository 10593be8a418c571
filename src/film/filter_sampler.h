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

    /// \throws std::invalid_argument as validate() does.
    explicit FilterSampler(const Filter& filter);

    /// u and v in [0, 1): two uniform numbers, for x and for y. Where a cubic through four of its points is f to 2e-6
    /// of the mean weight, which it is but for a few wide cells, the cubic stands for f. Agrees with sample_reference()
    /// to 1e-5 in the weight and to 1e-6 of the radius in the offsets.
    [[nodiscard]] FilterSample sample(float u, float v) const noexcept;

    struct Reference {
        double x_offset_px = 0.0, y_offset_px = 0.0, weight = 1.0;
    };
    /// The same in double precision, with f evaluated at each point.
    [[nodiscard]] Reference sample_reference(double u, double v) const noexcept;

    /// Density of x_offset_px (or y), 1/px: constant within a cell, 0 past the radius.
    [[nodiscard]] double pdf(FilterAxis axis, double offset_px) const noexcept;

    /// Of a weight; its mean is 1.
    [[nodiscard]] double mean_square_weight() const noexcept { return x_.mean_square_weight * y_.mean_square_weight; }

  private:
    // Offset start + t width and weight w0 + t (w1 + t (w2 + t w3)), for t in [0, 1] from the pixel's centre outwards.
    struct Cell {
        float start_px, width_px, w0, w1, w2, w3;
        bool is_cubic;  // false: no cubic is good enough
    };
    // One half-axis; the other is its mirror image.
    struct AxisTable {
        std::vector<double> edge_px;  // kCells + 1, from 0 to the radius
        std::vector<Cell> cells;      // kCells
        double integral_px = 0.0;     // of f over the whole axis, with its sign
        double mean_square_weight = 0.0;
    };
    struct AxisSample {
        float offset_px, weight;
    };
    struct AxisReference {
        double offset_px, weight;
    };

    [[nodiscard]] static AxisTable make_table(const Filter& filter, FilterAxis axis);
    [[nodiscard]] AxisSample sample_axis(FilterAxis axis, float u) const noexcept;
    [[nodiscard]] AxisReference sample_axis_reference(FilterAxis axis, double u) const noexcept;
    [[nodiscard]] const AxisTable& table(FilterAxis axis) const noexcept { return axis == FilterAxis::x ? x_ : y_; }

    Filter filter_;
    AxisTable x_, y_;
};

}  // namespace emulsion
