#include "tonemap/bloom.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/named_value.h"
#include "tonemap/copied.h"
#include "tonemap/spread_light.h"

namespace emulsion {

namespace {

/// (1 - d)^4 as a sum of Gaussians: a least-squares fit over the plane, all peaks >= 0, the widths in a fixed ratio.
constexpr std::array<GaussianLobe, 6> kUnitLobes = {{{.sigma_px = 0.25, .peak = 0.456917},
                                                     {.sigma_px = 0.131579, .peak = 0.240222},
                                                     {.sigma_px = 0.0692521, .peak = 0.149838},
                                                     {.sigma_px = 0.0364485, .peak = 0.0680716},
                                                     {.sigma_px = 0.0191834, .peak = 0.0380803},
                                                     {.sigma_px = 0.0100965, .peak = 0.034264}}};

double radius_px(const QuarticBloom& bloom, ImageView<const XYZ> scene) noexcept {
    return double{bloom.radius} * std::max(scene.width(), scene.height());
}

/// Whether anything spreads.
bool acts(const QuarticBloom& bloom, ImageView<const XYZ> scene) noexcept {
    return bloom.weight > 0.0f && radius_px(bloom, scene) > 1.0;
}

Image<XYZ> bloomed(const NoBloom&, ImageView<const XYZ> scene, int threads) { return copied(scene, threads); }

Image<XYZ> bloomed(const QuarticBloom& bloom, ImageView<const XYZ> scene, int threads) {
    if (!acts(bloom, scene)) return copied(scene, threads);
    std::vector<GaussianLobe> lobes(kUnitLobes.begin(), kUnitLobes.end());
    for (GaussianLobe& lobe : lobes) lobe.sigma_px *= radius_px(bloom, scene);
    return spread_light(scene, bloom.weight, lobes, threads);
}

}  // namespace

double quartic_kernel(double relative_distance) noexcept { return std::pow(std::max(0.0, 1.0 - relative_distance), 4); }

Image<XYZ> add_bloom(const Bloom& bloom, ImageView<const XYZ> scene, int threads) {
    validate_named(bloom, "bloom");
    return std::visit([&](const auto& chosen) { return bloomed(chosen, scene, threads); }, bloom);
}

Image<XYZd> add_bloom_reference(const Bloom& bloom, ImageView<const XYZ> scene) {
    validate_named(bloom, "bloom");
    const auto* quartic = std::get_if<QuarticBloom>(&bloom);
    const bool spreads = quartic != nullptr && acts(*quartic, scene);
    const double radius = spreads ? radius_px(*quartic, scene) : 1.0;
    const auto kernel = [&](double distance_px) { return quartic_kernel(distance_px / radius); };
    return spread_light_reference(scene, spreads ? double{quartic->weight} : 0.0, kernel, radius);
}

}  // namespace emulsion
