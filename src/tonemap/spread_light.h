#pragma once
// Spreading a part of the light of a picture, bad pixels (pixel_class.h) left alone.

#include <functional>
#include <span>

#include "core/color.h"
#include "core/image.h"
#include "tonemap/light_rows.h"
#include "tonemap/scatter.h"

namespace emulsion {

/// The good pixels of a picture as rows of X, Y and Z times a power of two, bad ones being 0.
struct GoodLight {
    LightRows rows;      ///< the picture must outlive them
    LightRows good;      ///< one channel: 1 where the pixel is good
    double scale = 1.0;  ///< so that no sum overflows or loses digits as denormals: 1 for any usual picture
    bool has_bad = false;
};

/// Looks at all pixels, of which there is one or more. \throws std::invalid_argument if threads < 0.
[[nodiscard]] GoodLight good_light(ImageView<const XYZ> scene, int threads);

/// (1 - weight) picture + weight (picture convolved with the sum of the lobes): see scatter(). What would fall on bad
/// pixels stays where it comes from, and bad pixels stay as they are; so the sum of the good ones stays, too, within
/// 1e-6, and what is constant but for bad pixels. Memory besides the result: two thirds of a picture, and another third
/// if there are bad pixels. The same bits for every number of threads (0: all).
/// \throws std::invalid_argument if the picture is empty or threads < 0.
[[nodiscard]] Image<XYZ> spread_light(ImageView<const XYZ> scene, double weight, std::span<const GaussianLobe> lobes,
                                      int threads);

/// The double-precision twin, on one thread: for every pixel the sum over all others of kernel(d_px), relative to its
/// sum over all pixels, the kernel being 0 past reach_px. Takes (2 width height)^2 steps.
[[nodiscard]] Image<XYZd> spread_light_reference(ImageView<const XYZ> scene, double weight,
                                                 const std::function<double(double)>& kernel, double reach_px);

}  // namespace emulsion
