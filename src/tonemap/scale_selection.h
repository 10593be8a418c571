#pragma once
// How wide a neighbourhood may grow about a pixel until it takes in something else: the largest scale before the
// difference between a Gaussian average and a wider one first gets too large. Luminances relative to the log-average.

#include <vector>

#include "core/image.h"

namespace emulsion {

/// B_i: the picture blurred by sigma_px[i]. The contrast of scale i, of n, is (B_i - B_{i+1}) / (floor[i] + B_i). The
/// result is B_i of the largest i for which |contrast| < limit there and at all smaller scales; if there is none, the
/// pixel's own luminance. (With B_0 then, as pixels beside a very bright one have a part of it, there would be dark
/// rims.)
///
/// Where |contrast| lies within half of the limit from it, what comes of accepting the scale and of stopping before it
/// are blended, linearly. Sources have a step at the limit: the least change of any pixel, even of one far off, then
/// makes others jump to another scale.
struct ScaleSelection {
    std::vector<double> sigma_px;  ///< n + 1 or more, n >= 1; > 0, rising
    std::vector<double> floor;     ///< n; >= 0. Of 0, where both averages are 0, the contrast is 0
    double limit = 0.0;            ///< > 0
};

/// In single precision. Wide scales are looked at in pictures of half the size, of a quarter and so on, each where its
/// averages are wide enough for that, and come back to the whole size by linear interpolation. The result takes the
/// place of `luminance`; beside that it needs at most one and a half times as much memory. The same bits for every
/// number of threads (0: all). \throws std::invalid_argument if threads < 0.
[[nodiscard]] Image<float> select_scales(const ScaleSelection& selection, Image<float> luminance, int threads);

/// The double-precision twin: direct convolution by every Gaussian.
[[nodiscard]] Image<double> select_scales_reference(const ScaleSelection& selection, const Image<double>& luminance);

}  // namespace emulsion
