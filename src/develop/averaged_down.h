#pragma once
// A picture made smaller: each pixel is the mean of a block of pixels, none of which is in two.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/color.h"
#include "core/image.h"
#include "core/row_blocks.h"

namespace emulsion {

/// Width and height of the picture with at most `most_px` in either, at least 1; never enlarged.
[[nodiscard]] inline std::pair<int, int> size_within(int width, int height, int most_px) noexcept {
    const double shrink = std::min(1.0, double(most_px) / std::max({width, height, 1}));
    const auto scaled = [shrink](int size) { return std::max(1, static_cast<int>(std::lround(shrink * size))); };
    return {scaled(width), scaled(height)};
}

/// Of the pixels of a block, as seen(pixel) has them, an std::optional<XYZ>; those that it leaves out don't count, and
/// a block of nothing else is black. Sums in double precision, the same bits for every number of threads (0: all).
/// \param width and \param height at least 1, and at most the picture's
template <class Seen>
Image<XYZ> averaged_down(const Image<XYZ>& picture, int width, int height, int threads, const Seen& seen) {
    // The pixels [first, second) that pixel `i` of `smaller` stands for.
    const auto stretch = [](int i, int smaller, int size) {
        const auto edge = [&](int at) { return static_cast<int>(std::int64_t{size} * at / smaller); };
        return std::pair(edge(i), edge(i + 1));
    };
    Image<XYZ> smaller(width, height);
    parallel_for_rows(width, height, threads, [&](int y) {
        const auto [y0, y1] = stretch(y, height, picture.height());
        for (int x = 0; x < width; ++x) {
            const auto [x0, x1] = stretch(x, width, picture.width());
            XYZd sum;
            int count = 0;
            for (int v = y0; v < y1; ++v) {
                for (int u = x0; u < x1; ++u) {
                    const std::optional<XYZ> pixel = seen(picture(u, v));
                    if (!pixel) continue;
                    sum = sum + XYZd{pixel->x, pixel->y, pixel->z};
                    ++count;
                }
            }
            if (count == 0) continue;
            const XYZd mean = (1.0 / count) * sum;
            smaller(x, y) = {static_cast<float>(mean.x), static_cast<float>(mean.y), static_cast<float>(mean.z)};
        }
    });
    return smaller;
}

}  // namespace emulsion
