#pragma once

#include <algorithm>

#include "core/color.h"
#include "core/image.h"

namespace emulsion {

/// Every component rounded to the nearest float; they must be in its range.
[[nodiscard]] inline Image<XYZ> in_single_precision(const Image<XYZd>& picture) {
    Image<XYZ> rounded(picture.width(), picture.height(), UnsetPixels{});
    std::ranges::transform(picture.pixels(), rounded.pixels().begin(), [](const XYZd& pixel) {
        return XYZ{static_cast<float>(pixel.x), static_cast<float>(pixel.y), static_cast<float>(pixel.z)};
    });
    return rounded;
}

}  // namespace emulsion
