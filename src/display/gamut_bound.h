#pragma once
// Where a line out of the gamut is to stop, for one bound of one component: what gamut=oklab is made of.

#include <array>

namespace emulsion {

/// c[0] + c[1] t + c[2] t^2 + c[3] t^3.
using Cubic = std::array<double, 4>;

[[nodiscard]] constexpr double value(const Cubic& c, double t) noexcept {
    return c[0] + t * (c[1] + t * (c[2] + t * c[3]));
}

/// By how much a bound may be broken where the line stops, as shares of c(0), what there is to the bound at its
/// begin. Chosen for lines near the blue corner of sRGB and BT.2020: see display/gamut_oklab.h.
inline constexpr double kLeastAllowance = 0.02, kMostAllowance = 0.12;

/// For a bound that asks for c(t) >= 0 and has it at t = 0: the mean, over all allowances a between the two, of the
/// greatest t in [0, end] with c(t) >= -a c(0). `end` itself if c(end) is no lower than the least allows. The place for
/// one allowance leaps where c comes up to it again only just, or only just not; their mean doesn't: it is continuous
/// in c and in end.
[[nodiscard]] double stop_of_bound(const Cubic& c, double end) noexcept;

}  // namespace emulsion
