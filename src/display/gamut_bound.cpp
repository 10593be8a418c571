#include "display/gamut_bound.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace emulsion {

namespace {

double slope(const Cubic& c, double t) noexcept { return c[1] + t * (2.0 * c[2] + t * 3.0 * c[3]); }

/// The local minimum and the local maximum of c in (0, end), where it has them there.
struct Turns {
    std::optional<double> lowest, highest;
};

Turns turns_within(const Cubic& c, double end) noexcept {
    // 3 c3 t^2 + 2 c2 t + c1 = 0, by the form that doesn't cancel; infinite where there is but one, NaN without any.
    const double half = c[2] + std::copysign(std::sqrt(c[2] * c[2] - 3.0 * c[3] * c[1]), c[2]);
    Turns turns;
    for (const double t : {-half / (3.0 * c[3]), -c[1] / half}) {
        if (t > 0.0 && t < end) (c[2] + 3.0 * c[3] * t > 0.0 ? turns.lowest : turns.highest) = t;
    }
    return turns;
}

/// The place in [low, high], over which c falls or rises only, where it comes through `level` from above: Newton's
/// method, halving where that leads out. An end of the stretch where c doesn't.
double place_of(const Cubic& c, double level, double low, double high) noexcept {
    double t = 0.5 * (low + high);
    for (int step = 0; step < 64 && low < high; ++step) {
        const double above = value(c, t) - level;
        (above >= 0.0 ? low : high) = t;
        const double next = t - above / slope(c, t);
        const double inside = next > low && next < high ? next : 0.5 * (low + high);
        if (inside == t || std::abs(inside - t) < 1e-16) break;
        t = inside;
    }
    return t;
}

/// The integral of the place over the levels that c has between low and high: of t d(-c), by parts.
double sum_of_places(const Cubic& c, double low, double high) noexcept {
    const auto integral = [&](double t) noexcept {
        return t * (c[0] + t * (c[1] / 2.0 + t * (c[2] / 3.0 + t * c[3] / 4.0)));
    };
    return low * value(c, low) - high * value(c, high) + integral(high) - integral(low);
}

}  // namespace

double stop_of_bound(const Cubic& c, double end) noexcept {
    const double top = -kLeastAllowance * c[0], bottom = -kMostAllowance * c[0];
    const double last = value(c, end);
    if (last >= top) return end;

    // Levels that c(end) has reached stop at the end. The others are met where c falls: on the way to the end, and, if
    // it has been lower and come up again to `returned`, levels above that before it was lowest.
    double sum = std::max(last - bottom, 0.0) * end;
    const auto add_levels = [&](double from, double to, double low, double high) noexcept {
        if (from > to) sum += sum_of_places(c, place_of(c, from, low, high), place_of(c, to, low, high));
    };
    const auto [lowest, highest] = turns_within(c, end);
    const double floor = std::max(last, bottom);
    if (!lowest) {
        add_levels(top, floor, highest.value_or(0.0), end);
    } else if (highest && *highest > *lowest) {
        const double returned = value(c, *highest);
        add_levels(std::min(top, returned), floor, *highest, end);
        add_levels(top, std::max(returned, bottom), 0.0, *lowest);
    } else {
        add_levels(top, floor, highest.value_or(0.0), *lowest);
    }
    return sum / (top - bottom);
}

}  // namespace emulsion
