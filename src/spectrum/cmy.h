#pragma once
// CMY, the complement of encoded RGB. No ink behaves so: a printer's CMY needs its profile.

#include <array>
#include <string_view>

#include "core/color.h"
#include "spectrum/color_values.h"

namespace emulsion {

/// 0: no ink, 1: full ink, for R'G'B' in [0, 1].
struct Cmy {
    double c = 0.0, m = 0.0, y = 0.0;
    bool operator==(const Cmy&) const = default;
};

/// C = 1 - R', M = 1 - G', Y = 1 - B', for every RGB.
/// Source: Foley, van Dam, Feiner & Hughes, Computer Graphics: Principles and Practice, 2nd ed. (1990), section 13.3.2.
[[nodiscard]] Cmy cmy_from_rgb(const RGBd& encoded) noexcept;
[[nodiscard]] RGBd rgb_from_cmy(const Cmy& cmy) noexcept;

struct CmySystem {
    static constexpr std::string_view kName = "cmy";
    static constexpr std::string_view kHelp = "complement of encoded RGB";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = {ColorComponent{"C", 0.0, 1.0, "", "cyan"},
                                               ColorComponent{"M", 0.0, 1.0, "", "magenta"},
                                               ColorComponent{"Y", 0.0, 1.0, "", "yellow"}};
    bool operator==(const CmySystem&) const = default;
};
[[nodiscard]] ColorValues from_xyz(const CmySystem& system, const XYZd& xyz, const ColorContext& context) noexcept;
[[nodiscard]] XYZd to_xyz(const CmySystem& system, const ColorValues& color, const ColorContext& context) noexcept;

}  // namespace emulsion
