#include "display/gamut_oklab.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "display/gamut_bound.h"
#include "display/gamut_scan.h"
#include "spectrum/oklab.h"

namespace emulsion {

namespace {

/// What each cone root of white has of Oklab's lightness.
std::array<double, 3> lightness_weights() noexcept {
    std::array<double, 3> weights = kOklabFromRoots.m[0];
    const double white = weights[0] + weights[1] + weights[2];
    for (double& weight : weights) weight /= white;
    return weights;
}

/// Components of the signal along the line from grey at t = 0, whose cone roots are all `grey`, to the colour at t = 1,
/// whose roots are grey + offset.
std::array<Cubic, 3> components_along(const DisplayGamut& gamut, double grey,
                                      const std::array<double, 3>& offset) noexcept {
    std::array<Cubic, 3> components{};
    for (std::size_t k = 0; k < 3; ++k) {
        double first = 0.0, second = 0.0, third = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double d = offset[i], part = gamut.rgb_from_cones.m[k][i] * d / gamut.light_span;
            first += part;
            second += part * d;
            third += part * d * d;
        }
        components[k] = {signal_of(gamut, grey * grey * grey), 3.0 * grey * grey * first, 3.0 * grey * second, third};
    }
    return components;
}

}  // namespace

RGBd map_gamut(const GamutOklab& /*mapper*/, const DisplayGamut& gamut, const RGBd& linear) noexcept {
    const auto is_inside = [](double v) noexcept { return v >= 0.0 && v <= 1.0; };
    if (is_inside(linear.r) && is_inside(linear.g) && is_inside(linear.b)) return linear;

    // A line of constant lightness and hue is straight in the cube roots of cone responses, too.
    static const std::array<double, 3> weights = lightness_weights();
    std::array<double, 3> roots =
        gamut.cones_from_rgb *
        std::array{light_of(gamut, linear.r), light_of(gamut, linear.g), light_of(gamut, linear.b)};
    for (double& root : roots) root = std::cbrt(root);
    const double grey = weights[0] * roots[0] + weights[1] * roots[1] + weights[2] * roots[2];
    if (!(signal_of(gamut, grey * grey * grey) > 0.0)) return {0.0, 0.0, 0.0};
    if (grey >= 1.0) return {1.0, 1.0, 1.0};
    const std::array<Cubic, 3> components =
        components_along(gamut, grey, {roots[0] - grey, roots[1] - grey, roots[2] - grey});

    // Each bound that is broken at t moves it inward, perhaps to where another one is: hence again. As often for every
    // colour, since that is what keeps all continuous; what is broken then, and what the bounds allow, is clipped.
    double t = 1.0;
    for (int round = 0; round < 3; ++round) {
        for (const Cubic& above : components) {
            t = stop_of_bound(above, t);
            t = stop_of_bound({1.0 - above[0], -above[1], -above[2], -above[3]}, t);
        }
    }
    const auto at = [&](std::size_t k) noexcept { return std::clamp(value(components[k], t), 0.0, 1.0); };
    return {at(0), at(1), at(2)};
}

GamutCounts map_gamut(const GamutOklab& mapper, const DisplayGamut& gamut, std::span<RGB> linear) noexcept {
    return map_outside_exactly(linear, [&](const RGBd& rgb) noexcept { return map_gamut(mapper, gamut, rgb); });
}

}  // namespace emulsion
