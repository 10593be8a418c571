#pragma once
// The bilateral filter at a cost that does not depend on its width.

#include "core/image.h"

namespace emulsion {

/// Replaces every value by the average of those about it, weighted by exp(-d^2 / (2 sigma_px^2)) of the distance and
/// exp(-d^2 / (2 sigma_value^2)) of the difference in value. Values are spread linearly over the nodes of a grid of
/// position and value, half a sigma apart (but never closer than pixels), the grid is blurred and read linearly; what
/// spreading and reading blur is taken off the Gaussians. Edges as mirrored_border.h.
/// Source: Chen, Paris & Durand, "Real-time Edge-Aware Image Processing with the Bilateral Grid", SIGGRAPH 2007, with a
/// grid twice as fine.
/// The same bits for every number of threads (0: all). \throws std::invalid_argument if threads < 0.
/// \param values finite, so that their range is less than 1e4 sigma_value \param sigma_px, sigma_value > 0
void bilateral_filter(ImageView<float> values, double sigma_px, double sigma_value, int threads);

}  // namespace emulsion
