#include "tonemap/luminance_table.h"

#include <limits>

#include "core/parallel.h"

namespace emulsion {

namespace {

/// The lower end of a cell, which are numbered by the bits that tell them.
double lower_end(std::uint32_t cell) noexcept {
    constexpr std::uint32_t kEnd = 255u << (23 - LuminanceTable::kShift);
    return cell == kEnd ? 0x1p128 : double{std::bit_cast<float>(cell << LuminanceTable::kShift)};
}

/// At the lower ends of `count` cells from `first` on.
std::vector<double> values_at_knots(const std::function<double(double)>& function, std::uint32_t first,
                                    std::size_t count, int threads) {
    constexpr std::size_t kChunk = 128;
    std::vector<double> values(count);
    parallel_for(0, static_cast<int>((count + kChunk - 1) / kChunk), threads, [&](int chunk) {
        const std::size_t begin = static_cast<std::size_t>(chunk) * kChunk;
        for (std::size_t i = begin; i < std::min(begin + kChunk, count); ++i) {
            values[i] = function(lower_end(first + static_cast<std::uint32_t>(i)));
        }
    });
    return values;
}

}  // namespace

LuminanceTable::LuminanceTable(const std::function<double(double)>& function, double min, double max, int threads) {
    constexpr auto kLargest = double{std::numeric_limits<float>::max()};
    least_bits_ = std::bit_cast<std::uint32_t>(static_cast<float>(std::clamp(min, 0.0, kLargest)));
    most_bits_ = std::bit_cast<std::uint32_t>(static_cast<float>(std::clamp(max, 0.0, kLargest)));
    first_cell_ = least_bits_ >> kShift;
    const std::size_t count = (most_bits_ >> kShift) - first_cell_ + 1;
    const std::vector<double> values = values_at_knots(function, first_cell_, count + 1, threads);
    // The first knot may be at 0, below all luminances.
    least_value_ = *std::min_element(values.begin() + 1, values.end());
    most_value_ = *std::max_element(values.begin() + 1, values.end());
    cells_.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double here = values[i], next = values[i + 1];
        const double slope = (next - here) / static_cast<double>(kFractionBits + 1);
        // Where either end, or the slope between them, would be denormal or infinite: no value.
        constexpr std::uint32_t kFirstNormal = 1u << (23 - kShift);
        const auto is_held = [](double value) { return value == 0.0 || (value > 0x1p-90 && value < 0x1p126); };
        const bool held = first_cell_ + i >= kFirstNormal && is_held(here) && is_held(next);
        is_whole_ = is_whole_ && held;
        const double value = held ? here : std::numeric_limits<double>::quiet_NaN();
        cells_.push_back(std::bit_cast<std::int64_t>(Cell{static_cast<float>(value), static_cast<float>(slope)}));
    }
}

}  // namespace emulsion
