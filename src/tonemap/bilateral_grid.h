#pragma once
// The bilateral filter at a cost that does not depend on its width.

#include "core/image.h"

namespace emulsion {

/// Replaces every luminance by 2^v, v being the average of log2 of those about it, weighted by exp(-d^2 / (2
/// sigma_px^2)) of the distance and exp(-d^2 / (2 sigma_octaves^2)) of the difference in log2. A luminance below the
/// least positive one, or below 2^-126, counts as that. Logarithms are spread linearly over the nodes of a grid of
/// position and value, half a sigma apart (but never closer than pixels), the grid is blurred and read linearly; what
/// spreading and reading blur is taken off the Gaussians. Edges as mirrored_border.h. Source: Chen, Paris & Durand,
/// "Real-time Edge-Aware Image Processing with the Bilateral Grid", SIGGRAPH 2007, with a grid twice as fine. The same
/// bits for every number of threads (0: all). \throws std::invalid_argument if threads < 0. \param luminance in [0,
/// 2^127) \param sigma_px, sigma_octaves > 0
void bilateral_filter(ImageView<float> luminance, double sigma_px, double sigma_octaves, int threads);

}  // namespace emulsion
