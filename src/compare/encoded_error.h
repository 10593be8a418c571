#pragma once
// How far two pictures are apart as they are sent to a display.

#include "core/color.h"
#include "core/image.h"
#include "develop/pipeline.h"

namespace emulsion {

/// Peak signal-to-noise ratio, dB: 10 log10(1 / mean of (b - a)^2), over R, G and B encoded by the pipeline, 1 at the
/// peak and held in [0, 1], before they become codes: without rounding and dithering. Infinite for equal pictures.
/// Bloom and vision are those of each picture, the tone curve and what it is adapted to those of `a`, so that a picture
/// that is only brighter is another one (PreparedToneMapping::as_other()). Pixels that are not finite in `a` or `b` are
/// left out; NaN if that is all of them. The same bits for every number of threads (0: all).
/// \throws std::invalid_argument if the pictures are empty or of different sizes, the pipeline is not valid, or threads
/// < 0.
[[nodiscard]] double encoded_psnr_db(const Image<XYZ>& a, const Image<XYZ>& b, const Pipeline& pipeline, int threads);

}  // namespace emulsion
