#include "tonemap/luminance_histogram.h"

#include <cstddef>
#include <numeric>

namespace emulsion {

LuminanceHistogram& LuminanceHistogram::operator+=(const LuminanceHistogram& other) noexcept {
    for (std::size_t bin = 0; bin < counts_.size(); ++bin) counts_[bin] += other.counts_[bin];
    return *this;
}

std::uint64_t LuminanceHistogram::total() const noexcept {
    return std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0});
}

double LuminanceHistogram::lower_end(int bin) noexcept {
    if (bin == kBins) return 0x1p128;
    return std::bit_cast<float>(static_cast<std::uint32_t>(bin) << static_cast<unsigned>(kShift));
}

double LuminanceHistogram::value_of_rank(double rank) const noexcept {
    double below = 0.0, value = 0.0;
    for (int bin = 0; bin < kBins; ++bin) {
        const auto here = static_cast<double>(count(bin));
        if (here == 0.0) continue;
        if (rank < below + here) {
            const double low = lower_end(bin);
            return low + (rank - below) / here * (lower_end(bin + 1) - low);
        }
        below += here;
        value = lower_end(bin + 1);
    }
    return value;
}

}  // namespace emulsion
