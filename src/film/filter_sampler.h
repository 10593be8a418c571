#pragma once
// Filter importance sampling: the sample's place in the pixel is drawn from the filter, and the sample then belongs to
// that one pixel with a signed weight. Same expected picture as splatting every sample into every pixel it reaches.
// Source: Ernst, Stamminger & Greiner, "Filter Importance Sampling", IEEE Symposium on Interactive Ray Tracing 2006.

#include <array>

#include "film/filter.h"

namespace emulsion {

/// Where a sample lies, and what it counts for.
struct FilterSample {
    float x_offset_px = 0.0f;  ///< from the pixel's centre, to the right; in [-radius, radius]
    float y_offset_px = 0.0f;  ///< from the pixel's centre, downwards; in [-radius, radius]
    float weight = 1.0f;       ///< f/pdf, of mean 1; negative in the filter's negative lobes
};

/// Draws positions with a density close to |f|: along each axis, kCells cells of equal probability, each of constant
/// density, so that the inverse of the distribution is one look-up and keeps the stratification of its input.
/// The weight holds f itself over that density, so that expectations do not depend on the number of cells. For a box
/// the inverse is exact and the weight always 1.
class FilterSampler {
  public:
    static constexpr int kCells = 1024;

    /// \throws std::invalid_argument as validate() does, and if the filter's integral along an axis is not positive:
    /// it could not be normalised.
    explicit FilterSampler(const Filter& filter);

    /// u and v in [0, 1): two uniform numbers, for x and for y.
    [[nodiscard]] FilterSample sample(float u, float v) const noexcept;

    /// Density of x_offset_px (or y), 1/px: constant within a cell, 0 past the radius.
    [[nodiscard]] double pdf(FilterAxis axis, double offset_px) const noexcept;

  private:
    struct AxisTable {
        std::array<double, kCells + 1> edge_px{};  // ends of the cells, from -radius to radius, rising
        double integral_px = 1.0;                  // of f over the axis, with its sign
    };
    struct AxisSample {
        double offset_px, weight;
    };

    [[nodiscard]] static AxisTable make_table(const Filter& filter, FilterAxis axis);
    [[nodiscard]] AxisSample sample_axis(FilterAxis axis, float u) const noexcept;
    [[nodiscard]] const AxisTable& table(FilterAxis axis) const noexcept { return axis == FilterAxis::x ? x_ : y_; }

    Filter filter_;
    AxisTable x_, y_;
};

}  // namespace emulsion
