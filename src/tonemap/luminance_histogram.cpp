#include "tonemap/luminance_histogram.h"

#include <cmath>
#include <cstddef>

namespace emulsion {

LuminanceHistogram& LuminanceHistogram::operator+=(const LuminanceHistogram& other) noexcept {
    for (std::size_t bin = 0; bin < cells_.size(); ++bin) cells_[bin] += other.cells_[bin];
    return *this;
}

std::uint64_t LuminanceHistogram::total() const noexcept {
    std::uint64_t total = 0;
    for (const std::uint64_t cell : cells_) total += cell >> kPlaceSumBits;
    return total;
}

double LuminanceHistogram::mean(int bin) const noexcept {
    const auto places = static_cast<double>(cell(bin) & (kOne - 1)), here = static_cast<double>(count(bin));
    const double low = lower_end(bin);
    return low + (places / here + 0.5) / static_cast<double>(kMostPlace + 1) * (lower_end(bin + 1) - low);
}

double LuminanceHistogram::lower_end(int bin) noexcept {
    // Bits of a double: an exponent, and 5 bits of its significand.
    constexpr std::uint64_t kExponentOfLeast = 1023 - 149;
    return std::bit_cast<double>((kExponentOfLeast * kBinsPerOctave + static_cast<std::uint64_t>(bin)) << (52u - 5u));
}

double LuminanceHistogram::value_of_rank(double rank) const noexcept {
    double below = 0.0;
    int last = -1;
    const auto number = [&](int bin) { return bin < 0 || bin == kBins ? 0.0 : static_cast<double>(count(bin)); };
    for (int bin = 0; bin < kBins; ++bin) {
        const double here = number(bin);
        if (here == 0.0) continue;
        last = bin;
        if (rank >= below + here) {
            below += here;
            continue;
        }
        const double past_middle = rank - below - 0.5 * here;
        const int neighbour = past_middle < 0.0 ? bin - 1 : bin + 1;
        const double there = number(neighbour);
        if (there == 0.0) return mean(bin);
        const double between = (here * mean(bin) + there * mean(neighbour)) / (here + there);
        const double share = std::abs(past_middle) / (0.5 * here);
        return (1.0 - share) * mean(bin) + share * between;
    }
    return last < 0 ? 0.0 : mean(last);
}

}  // namespace emulsion
