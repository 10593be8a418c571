#include "film/splat_block.h"

#include <algorithm>

namespace emulsion {

SplatBlock block_reached(const FilterFootprint& footprint, const PixelBounds& bounds, float x_px, float y_px,
                         WeightRoom& room) noexcept {
    const FilterFootprint::Weights all_x = footprint.weights(FilterAxis::x, x_px, room.x.data());
    const FilterFootprint::Weights all_y = footprint.weights(FilterAxis::y, y_px, room.y.data());
    const int x0 = std::max(all_x.reached.begin, bounds.x0), x1 = std::min(all_x.reached.end, bounds.x1);
    const int y0 = std::max(all_y.reached.begin, bounds.y0), y1 = std::min(all_y.reached.end, bounds.y1);
    if (x0 >= x1 || y0 >= y1) return {};
    const std::ptrdiff_t stride = bounds.width();
    return {static_cast<std::size_t>((y0 - bounds.y0) * stride + (x0 - bounds.x0)),
            stride,
            {all_x.first + (x0 - all_x.reached.begin), static_cast<std::size_t>(x1 - x0)},
            {all_y.first + (y0 - all_y.reached.begin), static_cast<std::size_t>(y1 - y0)}};
}

}  // namespace emulsion
