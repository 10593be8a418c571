#include "compare/difference_ramp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "spectrum/ciede2000_difference.h"
#include "spectrum/cielab.h"
#include "spectrum/color_context.h"

namespace emulsion {

namespace {

/// In CIELAB under D65: lightness rises by even steps, hue turns one way, from violet past red to yellow.
constexpr std::array<LchAb, 6> kColors = {{{0.0, 0.0, 300.0},
                                           {19.0, 38.0, 304.0},
                                           {38.0, 60.0, 340.0},
                                           {57.0, 66.0, 32.0},
                                           {76.0, 60.0, 72.0},
                                           {95.0, 40.0, 102.0}}};
constexpr int kSteps = 4096;         // along the curve, to measure it
constexpr std::size_t kSize = 1025;  // of the table

Lab color_at(int i) noexcept {
    return lab_from_lch(kColors[static_cast<std::size_t>(std::clamp(i, 0, static_cast<int>(kColors.size()) - 1))]);
}

/// Catmull-Rom through the colours, whose ends count twice; t in [0, 1].
Lab curve(double t) noexcept {
    const double place = t * static_cast<double>(kColors.size() - 1);
    const int i = std::min(static_cast<int>(place), static_cast<int>(kColors.size()) - 2);
    const double u = place - i;
    const auto blend = [&](double Lab::*part) {
        const double before = color_at(i - 1).*part, from = color_at(i).*part, to = color_at(i + 1).*part,
                     after = color_at(i + 2).*part;
        return from +
               0.5 * u *
                   (to - before +
                    u * (2.0 * before - 5.0 * from + 4.0 * to - after + u * (3.0 * (from - to) + after - before)));
    };
    return {blend(&Lab::l), blend(&Lab::a), blend(&Lab::b)};
}

}  // namespace

DifferenceRamp::DifferenceRamp() {
    std::vector<double> length(kSteps + 1, 0.0);
    for (int i = 1; i <= kSteps; ++i) {
        const Lab from = curve(static_cast<double>(i - 1) / kSteps), to = curve(static_cast<double>(i) / kSteps);
        length[static_cast<std::size_t>(i)] =
            length[static_cast<std::size_t>(i) - 1] + difference(Ciede2000Difference{}, from, to);
    }
    const ColorContext srgb;
    for (std::size_t k = 0; k < kSize; ++k) {
        const double wanted = length.back() * static_cast<double>(k) / static_cast<double>(kSize - 1);
        const auto after = std::max(std::ranges::lower_bound(length, wanted), length.begin() + 1);
        const double before = *(after - 1), part = (wanted - before) / (*after - before);
        const double t = (static_cast<double>(after - 1 - length.begin()) + part) / kSteps;
        encoded_.push_back(srgb.encoded_from_xyz(xyz_from_lab(curve(t), srgb.white())));
    }
}

RGBd DifferenceRamp::encoded(double share) const noexcept {
    const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(kSize - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(place), kSize - 2);
    const double u = place - static_cast<double>(i);
    return (1.0 - u) * encoded_[i] + u * encoded_[i + 1];
}

CodeRGB DifferenceRamp::code(double share) const noexcept {
    const RGBd color = encoded(share);
    const auto to_code = [](double component) {
        return static_cast<std::uint16_t>(std::lround(255.0 * std::clamp(component, 0.0, 1.0)));
    };
    return {to_code(color.r), to_code(color.g), to_code(color.b)};
}

}  // namespace emulsion
