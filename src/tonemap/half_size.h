#pragma once
// Pictures of half the size, and back: where wide neighbourhoods are looked at. AxisHalving says how; where sizes are
// even, as most are, in vectors. The same bits for every number of threads.

#include <span>

#include "core/image.h"
#include "tonemap/axis_halving.h"

namespace emulsion {

/// `picture` halved along both axes. Threads as in parallel_for. \throws std::invalid_argument if threads < 0.
[[nodiscard]] Image<float> half_size(const Image<float>& picture, const AxisHalving& x, const AxisHalving& y,
                                     int threads);

/// Row `y` of what `half`, which has the halved sizes of both axes, comes to at their full size.
/// \param scratch half.width() + 2 values; what is in them does not matter
void double_size_row(const Image<float>& half, const AxisHalving& x, const AxisHalving& y, int row,
                     std::span<float> scratch, std::span<float> out);

}  // namespace emulsion
