#include "tonemap/veiling_glare.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tonemap/spread_light.h"

namespace emulsion {

namespace {

/// veil_kernel as a sum of Gaussians: a least-squares fit relative to it, over the plane, all peaks >= 0, the widths in
/// a fixed ratio. Widths are tangents.
constexpr std::array<GaussianLobe, 9> kUnitLobes = {{{.sigma_px = 1.4, .peak = 0.0637226},
                                                     {.sigma_px = 0.7, .peak = 0.670192},
                                                     {.sigma_px = 0.35, .peak = 5.56615},
                                                     {.sigma_px = 0.175, .peak = 22.2896},
                                                     {.sigma_px = 0.0875, .peak = 90.7826},
                                                     {.sigma_px = 0.04375, .peak = 353.338},
                                                     {.sigma_px = 0.021875, .peak = 1344.0},
                                                     {.sigma_px = 0.0109375, .peak = 4178.63},
                                                     {.sigma_px = 0.00546875, .peak = 6688.06}}};

}  // namespace

double veil_kernel(double tangent) noexcept {
    constexpr double kFovea = 0.5 * std::numbers::pi / 180.0;
    const double angle = std::atan(tangent);
    return std::pow(std::cos(angle), 4.0) / (angle * angle + kFovea * kFovea);
}

Image<XYZ> add_veil(ImageView<const XYZ> scene, double share, double tangent_per_px, int threads) {
    std::vector<GaussianLobe> lobes(kUnitLobes.begin(), kUnitLobes.end());
    for (GaussianLobe& lobe : lobes) lobe.sigma_px /= tangent_per_px;
    return spread_light(scene, share, lobes, threads);
}

Image<XYZd> add_veil_reference(ImageView<const XYZ> scene, double share, double tangent_per_px) {
    const auto kernel = [&](double distance_px) { return veil_kernel(distance_px * tangent_per_px); };
    return spread_light_reference(scene, share, kernel, 20.0 / tangent_per_px);
}

}  // namespace emulsion
