#pragma once
// Are two noisy pictures of the same scene the same but for noise? Block by block: what differs by more than its own
// standard error allows is no noise.

#include <vector>

#include "core/color.h"
#include "core/image.h"

namespace emulsion::testing {

/// A difference of two means, with the standard error of that difference.
struct Difference {
    double value = 0.0;
    double standard_error = 0.0;

    /// In standard errors; 0 where nothing differs.
    [[nodiscard]] double z() const noexcept { return value == 0.0 ? 0.0 : value / standard_error; }
};

/// Of a block of pixels, or of a whole picture: picture less reference.
struct PictureDifference {
    Difference luminance;  ///< of mean Y, over the reference's
    Difference x, y;       ///< of the chromaticity of the mean XYZ
};

/// Blocks of size_px x size_px pixels, row by row; those at the right and lower edges may be smaller. The errors follow
/// from how much the differences of single pixels vary within a block: so the pixels of both pictures must be
/// independent, as they are under a box filter of one pixel, and have the same expectation if the pictures agree.
/// \throws std::invalid_argument unless both are of one size, size_px >= 2, and no block of the reference is black.
[[nodiscard]] std::vector<PictureDifference> block_differences(ImageView<const XYZ> picture,
                                                               ImageView<const XYZ> reference, int size_px);

/// The same of all pixels together.
[[nodiscard]] PictureDifference picture_difference(ImageView<const XYZ> picture, ImageView<const XYZ> reference);

}  // namespace emulsion::testing
