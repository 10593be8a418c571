#pragma once
// A picture of one's own from pixels that belong to someone else.

#include <algorithm>

#include "core/color.h"
#include "core/image.h"
#include "core/row_blocks.h"

namespace emulsion {

/// \throws std::invalid_argument if the picture is empty or threads < 0.
[[nodiscard]] inline Image<XYZ> copied(ImageView<const XYZ> picture, int threads) {
    Image<XYZ> copy(picture.width(), picture.height());
    parallel_for_rows(picture.width(), picture.height(), threads,
                      [&](int y) { std::copy(picture.row(y).begin(), picture.row(y).end(), copy.row(y).begin()); });
    return copy;
}

}  // namespace emulsion
