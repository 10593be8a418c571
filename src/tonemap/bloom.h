#pragma once
// Bloom: bright light spreads, in lenses and eyes. Scene-referred XYZ in cd/m^2 in and out, before tone mapping.

#include <array>
#include <string_view>
#include <variant>

#include "core/color.h"
#include "core/image.h"
#include "core/parameters.h"

namespace emulsion {

/// The picture as it is.
struct NoBloom {
    static constexpr std::string_view kName = "none";
    static constexpr std::string_view kHelp = "light stays where it is";
    bool operator==(const NoBloom&) const = default;
};

/// (1 - weight) picture + weight (picture convolved with k), k(d) = (1 - d / r)^4 for d < r, else 0, over its sum.
/// Source: Pharr & Humphreys, "Physically Based Rendering", 1st ed. 2004, section 8.4.2. Departs from its code, which
/// takes half of the radius, leaves out the pixel itself, and divides by the weights that lie in the picture, which
/// darkens or brightens edges: here r is the radius, the centre belongs to the kernel, and the picture is mirrored at
/// its edges, so that each of the sums of X, Y and Z is conserved and a constant stays as it is.
/// r may be any number of pixels; up to 1 px the kernel is the pixel itself. A pixel of 1e30 cd/m^2 blooms as any
/// other: that is the method.
struct QuarticBloom {
    static constexpr std::string_view kName = "quartic";
    static constexpr std::string_view kHelp = "a part of the light spreads over a disc, most of it close by";
    float radius = 0.1f;  ///< of the picture's larger side; in [0, 1]
    float weight = 0.1f;  ///< share of the light that spreads; in [0, 1]
    bool operator==(const QuarticBloom&) const = default;

    static constexpr std::array kParameters = {
        Parameter<QuarticBloom>{
            "radius", &QuarticBloom::radius, {0.0, 1.0}, "of the larger side", "radius of the disc"},
        Parameter<QuarticBloom>{"weight", &QuarticBloom::weight, {0.0, 1.0}, "", "share of the light that spreads"}};
};

/// The first is the default. core/named_value.h prints, parses and lists them.
using Bloom = std::variant<NoBloom, QuarticBloom>;

/// k relative to k(0), d over the radius; >= 0.
[[nodiscard]] double quartic_kernel(double relative_distance) noexcept;

/// Bad pixels (pixel_class.h) neither spread nor change; what would fall on them stays where it comes from. Each sum
/// over the good pixels is within 1e-6 of what it was, relative to that of the magnitudes. The kernel is within 5 % of
/// its peak of the twin's, and 2 % of the light that spreads falls elsewhere than the twin's at most. Cost grows with
/// the number of pixels only; memory besides the result: two thirds of a picture, a whole one with bad pixels.
/// The same bits for every number of threads (0: all).
/// \throws std::invalid_argument if a parameter is out of its range, the picture is empty, or threads < 0.
[[nodiscard]] Image<XYZ> add_bloom(const Bloom& bloom, ImageView<const XYZ> scene, int threads);

/// The double-precision twin: direct convolution.
[[nodiscard]] Image<XYZd> add_bloom_reference(const Bloom& bloom, ImageView<const XYZ> scene);

}  // namespace emulsion
