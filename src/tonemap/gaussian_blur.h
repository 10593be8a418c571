#pragma once
// A picture blurred by a Gaussian of any width, wide ones at no more cost than narrow ones.

#include "core/image.h"

namespace emulsion {

/// In single precision; wide blurs in a picture of half the size, a quarter and so on. Edges as mirrored_border.h. The
/// result takes the place of `picture`. Its twin is gaussian_blur_reference(). The same bits for every number of
/// threads (0: all). \param sigma_px standard deviation, in [0, 1e6] \throws std::invalid_argument if threads < 0.
[[nodiscard]] Image<float> gaussian_blur(Image<float> picture, double sigma_px, int threads);

}  // namespace emulsion
