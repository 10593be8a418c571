#include "film/exact_tile_pixel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace emulsion {

namespace {

/// Beyond are sums that have left every range; they are kept well within, so that quick terms don't bring them back.
constexpr std::int64_t kEnd = std::int64_t{1} << 62;
constexpr std::int64_t kSaturated = kEnd + kEnd / 2;

bool is_saturated(std::int64_t high) noexcept { return high >= kEnd || high <= -kEnd; }

}  // namespace

template <class Visit>
void ExactTilePixel::for_each_channel(const Visit& visit) noexcept {
    const auto visit_one = [&](Ints& highs, Ints& lows, int place, std::size_t channel, auto sum) {
        std::int64_t high = highs[place], low = lows[place];
        visit(high, low, channel, sum);
        highs[place] = high;
        lows[place] = low;
    };
    visit_one(high_xy_, low_xy_, 0, 0, ExactSum{});
    visit_one(high_xy_, low_xy_, 1, 1, ExactSum{});
    visit_one(high_zw_, low_zw_, 0, 2, ExactSum{});
    visit_one(high_zw_, low_zw_, 1, 3, ExactWeightSum{});
}

void ExactTilePixel::carry() noexcept {
    for_each_channel([]<class Sum>(std::int64_t& high, std::int64_t& low, std::size_t, const Sum&) {
        if (is_saturated(high)) {
            high = high < 0 ? -kSaturated : kSaturated;
            low = 0;
            return;
        }
        constexpr int kShift = Sum::kFractionBits - kHighFractionBits;
        high += low >> kShift;
        low &= (std::int64_t{1} << kShift) - 1;
    });
}

bool ExactTilePixel::add_large(const std::array<double, 4>& terms) noexcept {
    if (!std::all_of(terms.begin(), terms.end(), [](double term) { return std::isfinite(term); })) return false;
    for_each_channel([&]<class Sum>(std::int64_t& high, std::int64_t& low, std::size_t channel, const Sum&) {
        if (is_saturated(high)) return;
        const double term = terms[channel];
        if (std::abs(term) >= Sum::kLimit) {
            high = term < 0.0 ? -kSaturated : kSaturated;
            return;
        }
        constexpr int kShift = Sum::kFractionBits - kHighFractionBits;
        const auto units = static_cast<Int128>(std::nearbyint(std::ldexp(term, Sum::kFractionBits)));
        high += static_cast<std::int64_t>(units >> kShift);
        low += static_cast<std::int64_t>(units & ((Int128{1} << kShift) - 1));
    });
    return true;
}

}  // namespace emulsion
