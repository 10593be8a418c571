#pragma once
// A picture of pictures: one tile for each tone mapping operator, for choosing by eye.

#include "core/color.h"
#include "core/image.h"
#include "develop/pipeline.h"
#include "display/code_value.h"

namespace emulsion {

/// Every operator of the variant with its defaults, in its order, row by row, each with its name below. The operators
/// see the whole picture; what they made is then averaged down to at most `tile_px` pixels in width and in height. The
/// other stages are those of the pipeline, whose tone mapper and adaptation are not used.
/// \param tile_px 16 to 4096
/// \throws std::invalid_argument if the picture is empty, the pipeline not valid, tile_px out of range or threads < 0.
[[nodiscard]] Image<CodeRGB> contact_sheet(const Image<XYZ>& scene, const Pipeline& pipeline, int tile_px, int threads);

}  // namespace emulsion
