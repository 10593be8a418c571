#pragma once
// A scene-referred picture as files of others hold it: no layers, no film.

#include <string>
#include <vector>

#include "core/color.h"
#include "core/image.h"

namespace emulsion {

struct ScenePicture {
    Image<XYZ> xyz;                       ///< Y in cd/m^2
    std::vector<std::string> notes = {};  ///< what was assumed or left out, one sentence each
};

/// For the formats that have linear RGB and no word for what it means: the values are those that pfstools and
/// OpenImageIO expect, linear Rec. 709 (D65), scene-referred, here of which (1, 1, 1) is the white of so many cd/m^2.
struct SceneWriteOptions {
    double white_luminance_cdm2 = 1.0;  ///< in [1e-30, 1e30]
    bool operator==(const SceneWriteOptions&) const = default;
};

}  // namespace emulsion
