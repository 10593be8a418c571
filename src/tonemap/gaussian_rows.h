#pragma once
// Gaussian blurs of one picture by several widths at once, a row at a time, so that the blurred pictures need no
// memory.

#include <cstddef>
#include <span>
#include <vector>

#include "core/image.h"

namespace emulsion {

/// Rows of `source` blurred by each of some Gaussians, in single precision; mirrored_border.h at the edges. Every row
/// is computed from the source alone, so that its bits do not depend on which rows came before. One thread each.
class GaussianRows {
  public:
    /// \param sigma_px standard deviations in pixels, >= 0 \param tail share of each Gaussian that is left out, in (0,
    /// 1) `source` must outlive this.
    GaussianRows(ImageView<const float> source, std::span<const double> sigma_px, double tail);

    /// Blurs row `y`.
    void compute(int y);

    /// The row computed last, blurred by the Gaussian number `i`; its width is the source's.
    [[nodiscard]] std::span<const float> row(std::size_t i) const noexcept { return levels_[i].blurred; }

  private:
    struct Level {
        std::vector<float> kernel;   ///< of offsets 0 .. radius
        std::vector<float> columns;  ///< blurred from row to row: `radius` pixels more at each end
        std::vector<float> blurred;  ///< and along the row
        [[nodiscard]] int radius() const noexcept { return static_cast<int>(kernel.size()) - 1; }
        [[nodiscard]] std::span<const float* const> taps(std::span<const float* const> enough) const noexcept {
            return enough.first(2 * kernel.size() - 1);
        }
    };

    void blur_columns(Level& level, int y, int x0, int x1);
    void blur_along(Level& level);

    ImageView<const float> source_;
    std::vector<Level> levels_;
    std::vector<const float*> taps_;
};

/// The double-precision twin: the whole picture, by direct convolution as wide as double precision can tell.
[[nodiscard]] Image<double> gaussian_blur_reference(const Image<double>& source, double sigma_px);

}  // namespace emulsion
