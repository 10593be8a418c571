#pragma once
// The scene-referred picture that charts of pictures are of.

#include "core/color.h"
#include "core/image.h"

namespace emulsion {

/// Four decades in steps and slopes, coloured, with the noise of a few hundred samples a pixel. Y in cd/m^2. The same
/// in every run.
[[nodiscard]] Image<XYZ> chart_scene(int width_px, int height_px);

}  // namespace emulsion
