#include "display/separation.h"

#include <algorithm>
#include <cstddef>

#include "core/visit.h"
#include "display/code_value.h"

namespace emulsion {

namespace {

double black_of(const NoBlackInk& /*black*/, double /*grey*/) noexcept { return 0.0; }
double black_of(const GreyReplacement& black, double grey) noexcept { return black.amount * grey; }
double black_of(const UnderColorRemoval& black, double grey) noexcept {
    return black.amount * std::max(0.0, (grey - black.start) / (1.0 - black.start));
}

}  // namespace

Cmyk separate(const BlackGeneration& black, const RGBd& encoded) noexcept {
    const double greatest = std::max({encoded.r, encoded.g, encoded.b});
    const double k = visit_noexcept([&](const auto& chosen) { return black_of(chosen, 1.0 - greatest); }, black);
    const double rest = 1.0 - k;
    if (rest == 0.0) return {0.0, 0.0, 0.0, 1.0};
    // Rounding may lead out of [0, 1] by a last bit.
    const auto ink = [&](double component) noexcept { return std::clamp((rest - component) / rest, 0.0, 1.0); };
    return {ink(encoded.r), ink(encoded.g), ink(encoded.b), k};
}

void separate(const BlackGeneration& black, std::span<const RGB> encoded, std::span<Inks> inks) noexcept {
    for (std::size_t i = 0; i < encoded.size(); ++i) {
        const RGB& p = encoded[i];
        const Cmyk exact = separate(black, {unit_clamp(p.r), unit_clamp(p.g), unit_clamp(p.b)});
        inks[i] = {static_cast<float>(exact.c), static_cast<float>(exact.m), static_cast<float>(exact.y),
                   static_cast<float>(exact.k)};
    }
}

void recombine(std::span<const Inks> inks, std::span<RGB> encoded) noexcept {
    for (std::size_t i = 0; i < inks.size(); ++i) {
        const RGBd exact = rgb_from_cmyk({inks[i].c, inks[i].m, inks[i].y, inks[i].k});
        encoded[i] = {static_cast<float>(exact.r), static_cast<float>(exact.g), static_cast<float>(exact.b)};
    }
}

}  // namespace emulsion
