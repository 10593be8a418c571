#pragma once
// Pictures of half the size, and back: where wide neighbourhoods are looked at. A pixel of the half lies in the middle
// of four pixels of the whole; of an odd size the half is rounded up. mirrored_border.h at the edges.

#include <span>

#include "core/image.h"

namespace emulsion {

/// Variance that half_size() adds, in squared pixels of the half: of the weights 1 3 3 1.
inline constexpr double kHalfSizeVariance = 0.1875;
/// Variance that double_row() adds, in squared pixels of the half: of the weights 3 1, the same for all pixels.
inline constexpr double kDoubleSizeVariance = 0.1875;

/// Weighted by 1 3 3 1 in x and y. The same bits for every number of threads (0: all).
/// \throws std::invalid_argument if threads < 0.
[[nodiscard]] Image<float> half_size(ImageView<const float> source, int threads);

/// Row `y` of the whole, between whose pixels those of `half` lie, by linear interpolation.
/// \param scratch half.width() + 2 values; what is in them does not matter
void double_row(ImageView<const float> half, int y, std::span<float> scratch, std::span<float> row) noexcept;

}  // namespace emulsion
