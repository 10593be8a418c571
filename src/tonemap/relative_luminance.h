#pragma once
// Luminance made ready for averages over neighbourhoods: relative to the picture's log-average, without bad pixels and
// without outliers, so that one such pixel does not spread.

#include "core/color.h"
#include "core/image.h"
#include "tonemap/scene_luminance.h"

namespace emulsion {

/// Y / log_average(Y) of every pixel, one or more of which is positive; >= 0 and below 2^120. Bad pixels and outliers
/// have the median of the good pixels in the smallest square about them, of up to 9 x 9, that has any, or else 1: of
/// those that lie opposite each other, if there are any, so that at the edge of a picture, too, they have what lies
/// between. T: float, or double for the twins. Same bits for every number of threads (0: all). \throws
/// std::invalid_argument if threads < 0.
template <class T>
[[nodiscard]] Image<T> relative_luminance(ImageView<const XYZ> scene, const SceneLuminance& luminance, int threads);

extern template Image<float> relative_luminance(ImageView<const XYZ>, const SceneLuminance&, int);
extern template Image<double> relative_luminance(ImageView<const XYZ>, const SceneLuminance&, int);

}  // namespace emulsion
