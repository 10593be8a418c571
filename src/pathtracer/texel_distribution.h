#pragma once
// Points of the unit square by the weights of the texels that they lie in: rows first, then columns in the row, so that
// well spread pairs of numbers stay well spread.

#include <array>
#include <vector>

#include <Imath/ImathVec.h>

#include "core/image.h"

namespace emulsion {

class TexelDistribution {
  public:
    /// Weights are finite and >= 0; row 0 is the one at v = 0. If all are 0, all texels are taken alike.
    explicit TexelDistribution(const Image<float>& weights);

    /// u in [0, 1)^2 to a point (u, v) of [0, 1)^2; in double precision, lest it be rounded out of its texel.
    [[nodiscard]] Imath::V2d sample(std::array<float, 2> u) const noexcept;

    /// The density of points in a texel: exactly that of sample(), as tables have it in single precision. Texels of a
    /// share below some 1e-7 may be left out, and have 0.
    [[nodiscard]] float density(int x, int y) const noexcept;

  private:
    // Cumulative shares, from 0 to 1: of the rows, and of the columns in each row.
    int width_, height_;
    std::vector<float> rows_, columns_;

    [[nodiscard]] const float* columns_of(int y) const noexcept {
        return columns_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width_ + 1);
    }
};

}  // namespace emulsion
