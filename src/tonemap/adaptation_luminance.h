#pragma once
// The luminance that the eye, or the film, is adapted to: one for the picture, or one for each pixel.

#include "core/image.h"

namespace emulsion {

/// T: float, or double for the twins.
template <class T>
struct BasicAdaptationLuminance {
    double uniform_cdm2 =
        0.0;              ///< of the whole picture; where each pixel has its own, the log-average of SceneLuminance
    Image<T> local = {};  ///< of each pixel over uniform_cdm2, >= 0; empty: uniform_cdm2 for all
};
using AdaptationLuminance = BasicAdaptationLuminance<float>;

}  // namespace emulsion
