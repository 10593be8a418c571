#pragma once
// The one rule for what lies beyond the edges of a picture, wherever this room averages over neighbourhoods.

#include <algorithm>

namespace emulsion {

/// The pixel, in [0, count), count >= 1, that stands for the pixel `i`, which may lie outside: mirrored at the edges of
/// the outer pixels, ... 1 0 | 0 1 2 ... n-1 | n-1 n-2 ..., again and again. Unlike a repeated edge pixel this gives no
/// pixel more weight than others, and a picture blurred twice is the one blurred once by both together, up to its
/// edges.
[[nodiscard]] constexpr int mirrored(int i, int count) noexcept {
    if (i >= 0 && i < count) return i;
    const long period = 2L * std::max(count, 1);
    const long wrapped = (i % period + period) % period;
    return static_cast<int>(wrapped < count ? wrapped : period - 1 - wrapped);
}

}  // namespace emulsion
