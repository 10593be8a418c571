#pragma once
// Filter importance sampling: the sample's place in the pixel is drawn from the filter, and the sample then belongs to
// that one pixel with a signed weight. Same expected picture as splatting every sample into every pixel it reaches.
// Source: Ernst, Stamminger & Greiner, "Filter Importance Sampling", IEEE Symposium on Interactive Ray Tracing 2006.

#include <array>
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

/// Draws positions with a density close to |f|: along each axis, 1024 cells of equal probability, each of constant
/// density, so that the inverse of the distribution is one look-up and keeps the stratification of its input.
/// The weight holds f itself over that density, so that the expectation does not depend on the number of cells. For a
/// box the inverse is exact and the weight always 1.
class FilterSampler {
  public:
    /// \throws std::invalid_argument as validate() does, and if the filter's integral is not positive: it could not
    /// be normalised.
    explicit FilterSampler(const Filter& filter);

    /// u and v in [0, 1): two uniform numbers, for x and for y.
    [[nodiscard]] FilterSample sample(float u, float v) const noexcept;

    /// The same in double precision with f evaluated at the point, not interpolated; offsets agree with sample() to
    /// 1e-6 of the radius.
    struct Reference {
        double x_offset_px = 0.0, y_offset_px = 0.0, weight = 1.0;
    };
    [[nodiscard]] Reference sample_reference(double u, double v) const noexcept;

  private:
    static constexpr int kCells = 1024;
    static constexpr float kCellsFloat = kCells;

    struct AxisTable {
        std::array<double, kCells + 1> edge_px{};  // ends of the cells, from -radius to radius, rising
        double integral_px = 1.0;                  // of f over the axis, with its sign
    };

    Filter filter_;
    AxisTable x_, y_;
};

}  // namespace emulsion
