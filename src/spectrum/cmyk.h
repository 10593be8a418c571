#pragma once
// CMYK with full black generation, of encoded RGB. No ink behaves so: a printer's CMYK needs its profile.

#include <array>
#include <string_view>

#include "core/color.h"
#include "spectrum/color_values.h"

namespace emulsion {

/// 0: no ink, 1: full ink, for R'G'B' in [0, 1]. One of c, m, y is 0.
struct Cmyk {
    double c = 0.0, m = 0.0, y = 0.0, k = 0.0;
    bool operator==(const Cmyk&) const = default;
};

/// K = min of CMY = 1 - max(R', G', B'), the rest relative to what black leaves: c = (C - K) / (1 - K). Black is
/// (0, 0, 0, 1). Outside [0, 1]^3 the formulas go on, and stay invertible: inks above 1 where a component is negative,
/// K < 0 above white. Where the greatest component is 0 and another negative, that one's ink is infinite. NaN in one
/// component is NaN in all.
/// Source: Foley, van Dam, Feiner & Hughes, Computer Graphics: Principles and Practice, 2nd ed. (1990), section 13.3.2,
/// whose inks are C - K; ours are over 1 - K, so that they have the whole range beside any black.
[[nodiscard]] Cmyk cmyk_from_rgb(const RGBd& encoded) noexcept;

/// R' = (1 - c)(1 - K) and so on: for every CMYK, also with other black generation; NaN for an infinite ink.
[[nodiscard]] RGBd rgb_from_cmyk(const Cmyk& cmyk) noexcept;

struct CmykSystem {
    static constexpr std::string_view kName = "cmyk";
    static constexpr std::string_view kHelp = "complement of encoded RGB with full black generation";
    static constexpr std::string_view kDomain = "all but max(R', G', B') = 0 with another negative";
    static constexpr std::array kComponents = {
        ColorComponent{"C", 0.0, 1.0, "", "cyan"}, ColorComponent{"M", 0.0, 1.0, "", "magenta"},
        ColorComponent{"Y", 0.0, 1.0, "", "yellow"}, ColorComponent{"K", 0.0, 1.0, "", "black"}};
    bool operator==(const CmykSystem&) const = default;
};
[[nodiscard]] ColorValues from_xyz(const CmykSystem& system, const XYZd& xyz, const ColorContext& context) noexcept;
[[nodiscard]] XYZd to_xyz(const CmykSystem& system, const ColorValues& color, const ColorContext& context) noexcept;

}  // namespace emulsion
