#include "display/gamut_oklab.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "display/gamut_scan.h"
#include "spectrum/oklab.h"

namespace emulsion {

namespace {

/// c[0] + c[1] t + c[2] t^2 + c[3] t^3.
using Cubic = std::array<double, 4>;

double value(const Cubic& c, double t) noexcept { return c[0] + t * (c[1] + t * (c[2] + t * c[3])); }
double slope(const Cubic& c, double t) noexcept { return c[1] + t * (2.0 * c[2] + t * 3.0 * c[3]); }

/// Where the slope is 0: two places in rising order, or two NaN.
std::array<double, 2> turning_points(const Cubic& c) noexcept {
    // 3 c3 t^2 + 2 c2 t + c1 = 0, by the form that doesn't cancel; infinite where there is but one.
    const double half = c[2] + std::copysign(std::sqrt(c[2] * c[2] - 3.0 * c[3] * c[1]), c[2]);
    const double first = -half / (3.0 * c[3]), second = -c[1] / half;
    return {std::min(first, second), std::max(first, second)};
}

/// The zero of c in [low, high], over which it is monotone, rises or falls through 0 and is >= 0 at `low`: Newton's
/// method, halving where that leads out. The value at what is returned is >= 0 but for rounding.
double zero_between(const Cubic& c, double low, double high) noexcept {
    double t = 0.5 * (low + high);
    for (int step = 0; step < 64 && low < high; ++step) {
        const double at = value(c, t);
        (at >= 0.0 ? low : high) = t;
        const double next = t - at / slope(c, t);
        const double inside = next > low && next < high ? next : 0.5 * (low + high);
        if (inside == t || std::abs(inside - t) < 1e-16) break;
        t = inside;
    }
    return t;
}

/// The largest t in [0, end] with c(t) >= 0, for a cubic that is positive at 0 and negative at `end`.
double last_not_negative(const Cubic& c, double end) noexcept {
    const auto [first, second] = turning_points(c);
    double high = end;
    for (const double turn : {second, first}) {
        if (!(turn > 0.0 && turn < high)) continue;
        if (value(c, turn) >= 0.0) return zero_between(c, turn, high);
        high = turn;
    }
    return zero_between(c, 0.0, high);
}

/// What each cone root of white has of Oklab's lightness.
std::array<double, 3> lightness_weights() noexcept {
    std::array<double, 3> weights = kOklabFromRoots.m[0];
    const double white = weights[0] + weights[1] + weights[2];
    for (double& weight : weights) weight /= white;
    return weights;
}

/// Components of RGB along the line from grey at t = 0, whose cone roots are all `grey`, to the colour at t = 1, whose
/// roots are grey + offset.
std::array<Cubic, 3> components_along(const DisplayGamut& gamut, double grey,
                                      const std::array<double, 3>& offset) noexcept {
    std::array<Cubic, 3> components{};
    for (std::size_t k = 0; k < 3; ++k) {
        double first = 0.0, second = 0.0, third = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double d = offset[i], part = gamut.rgb_from_cones.m[k][i] * d;
            first += part;
            second += part * d;
            third += part * d * d;
        }
        components[k] = {grey * grey * grey, 3.0 * grey * grey * first, 3.0 * grey * second, third};
    }
    return components;
}

}  // namespace

RGBd map_gamut(const GamutOklab& /*mapper*/, const DisplayGamut& gamut, const RGBd& linear) noexcept {
    const auto is_inside = [](double v) noexcept { return v >= 0.0 && v <= 1.0; };
    if (is_inside(linear.r) && is_inside(linear.g) && is_inside(linear.b)) return linear;

    // A line of constant lightness and hue is straight in the cube roots of cone responses, too.
    static const std::array<double, 3> weights = lightness_weights();
    std::array<double, 3> roots = gamut.cones_from_rgb * std::array{linear.r, linear.g, linear.b};
    for (double& root : roots) root = std::cbrt(root);
    const double grey = weights[0] * roots[0] + weights[1] * roots[1] + weights[2] * roots[2];
    if (!(grey > 0.0)) return {0.0, 0.0, 0.0};
    if (grey >= 1.0) return {1.0, 1.0, 1.0};
    const std::array<Cubic, 3> components =
        components_along(gamut, grey, {roots[0] - grey, roots[1] - grey, roots[2] - grey});

    // Each bound that is broken at t moves it inward; the last pass finds none broken.
    double t = 1.0;
    for (bool moved = true; moved && t > 0.0;) {
        moved = false;
        for (const Cubic& above : components) {
            const Cubic below = {1.0 - above[0], -above[1], -above[2], -above[3]};
            for (const Cubic& c : {above, below}) {
                if (value(c, t) >= -1e-15) continue;
                t = last_not_negative(c, t);
                moved = true;
            }
        }
    }
    const auto at = [&](std::size_t k) noexcept { return std::clamp(value(components[k], t), 0.0, 1.0); };
    return {at(0), at(1), at(2)};
}

GamutCounts map_gamut(const GamutOklab& mapper, const DisplayGamut& gamut, std::span<RGB> linear) noexcept {
    return map_outside_exactly(linear, [&](const RGBd& rgb) noexcept { return map_gamut(mapper, gamut, rgb); });
}

}  // namespace emulsion
