#pragma once
// Gaussian blurs of one picture by several widths at once, a row at a time, so that the blurred pictures need no
// memory.

#include <cstddef>
#include <span>
#include <vector>

#include "core/image.h"

namespace emulsion {

/// Standard deviations along both axes, in pixels; >= 0.
struct GaussianSigma {
    double x_px = 0.0, y_px = 0.0;
};

/// Rows of a picture blurred by each of some Gaussians, in single precision; mirrored_border.h at the edges. One thread
/// each.
class GaussianRows {
  public:
    /// \param width of the picture, >= 1 \param tail share of each Gaussian that is left out, in (0, 1)
    GaussianRows(int width, std::span<const GaussianSigma> sigmas, double tail);

    /// How many rows above and below a row it takes to blur it.
    [[nodiscard]] int radius() const noexcept { return radius_; }

    /// Blurs the row in the middle of 2 radius() + 1 rows of the picture.
    void compute(std::span<const float* const> rows);

    /// The row computed last, blurred by the Gaussian number `i`.
    [[nodiscard]] std::span<const float> row(std::size_t i) const noexcept { return levels_[i].blurred; }

  private:
    /// Kernels are those of offsets 0 .. radius.
    struct Level {
        std::vector<float> across, down;
        std::vector<float> columns;  ///< blurred from row to row: the radius of `across` more at each end
        std::vector<float> blurred;  ///< and along the row
    };

    void blur_columns(Level& level, std::span<const float* const> rows, int x0, int x1);
    void blur_along(Level& level);

    int width_, radius_ = 0;
    std::vector<Level> levels_;
    std::vector<const float*> taps_;
};

/// The double-precision twin: the whole picture, by direct convolution as wide as double precision can tell.
[[nodiscard]] Image<double> gaussian_blur_reference(const Image<double>& source, double sigma_px);

}  // namespace emulsion
