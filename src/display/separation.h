#pragma once
// Separation into inks, for previews of prints: encoded RGB to cyan, magenta, yellow and black. No ink behaves so (see
// spectrum/cmyk.h): what is exact here is that the inks, put over one another again, give the RGB that they came from.

#include <array>
#include <span>
#include <string_view>
#include <variant>

#include "core/color.h"
#include "core/parameters.h"
#include "spectrum/cmyk.h"

namespace emulsion {

/// K = 0.
struct NoBlackInk {
    static constexpr std::string_view kName = "none";
    static constexpr std::string_view kHelp = "cyan, magenta and yellow only";
    bool operator==(const NoBlackInk&) const = default;
};

/// Grey component replacement: K = amount g, with the grey component g = min(1 - R', 1 - G', 1 - B').
/// Source: Yule, "Principles of Color Reproduction", 1967.
struct GreyReplacement {
    static constexpr std::string_view kName = "gcr";
    static constexpr std::string_view kHelp = "black for a part of the grey in every colour";
    double amount = 1.0;  ///< in [0, 1]; 1 leaves two of the other inks at most
    bool operator==(const GreyReplacement&) const = default;

    static constexpr std::array kParameters = {Parameter<GreyReplacement>{
        "amount", &GreyReplacement::amount, {0.0, 1.0}, "", "part of the grey component that becomes black"}};
};

/// Under-colour removal: the same of dark colours only, K = amount max(0, g - start) / (1 - start).
/// Source: as above; a "skeleton black".
struct UnderColorRemoval {
    static constexpr std::string_view kName = "ucr";
    static constexpr std::string_view kHelp = "black for the grey in dark colours";
    double amount = 1.0;  ///< in [0, 1], K of black
    double start = 0.5;   ///< grey component that is left to the other inks; in [0, 1)
    bool operator==(const UnderColorRemoval&) const = default;

    static constexpr std::array kParameters = {
        Parameter<UnderColorRemoval>{"amount", &UnderColorRemoval::amount, {0.0, 1.0}, "", "black ink in black"},
        Parameter<UnderColorRemoval>{"start",
                                     &UnderColorRemoval::start,
                                     {0.0, 1.0, RangeEnd::closed, RangeEnd::open},
                                     "",
                                     "grey component where black begins"}};
};

/// All ways to make black; the first is the default.
using BlackGeneration = std::variant<GreyReplacement, UnderColorRemoval, NoBlackInk>;

/// c = (1 - R' - K) / (1 - K) and so on, each in [0, 1]; (0, 0, 0, 1) where K is 1. rgb_from_cmyk() is the inverse.
/// \param black with parameters in their ranges
/// \param encoded components in [0, 1]
[[nodiscard]] Cmyk separate(const BlackGeneration& black, const RGBd& encoded) noexcept;

/// Inks of a picture, 0 none to 1 full.
struct Inks {
    float c = 0.0f, m = 0.0f, y = 0.0f, k = 0.0f;
    bool operator==(const Inks&) const = default;
};

/// Of many pixels, by the same; components outside [0, 1] are taken as the nearest inside, NaN as 0. As many of one as
/// of the other. Rounded to single precision only at the end.
void separate(const BlackGeneration& black, std::span<const RGB> encoded, std::span<Inks> inks) noexcept;

/// What the inks look like over one another: encoded RGB, (1 - c)(1 - k) and so on; within 1.2e-7 of what was
/// separated.
void recombine(std::span<const Inks> inks, std::span<RGB> encoded) noexcept;

}  // namespace emulsion
