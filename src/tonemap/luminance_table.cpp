#include "tonemap/luminance_table.h"

#include <limits>

namespace emulsion {

LuminanceTable::LuminanceTable(const std::function<double(double)>& function, double min, double max) {
    constexpr auto kLargest = double{std::numeric_limits<float>::max()};
    least_bits_ = std::bit_cast<std::uint32_t>(static_cast<float>(std::clamp(min, 0.0, kLargest)));
    most_bits_ = std::bit_cast<std::uint32_t>(static_cast<float>(std::clamp(max, 0.0, kLargest)));
    first_cell_ = least_bits_ >> kShift;
    const std::uint32_t last_cell = most_bits_ >> kShift;
    const auto lower_end = [](std::uint32_t cell) {
        constexpr std::uint32_t kEnd = 255u << (23 - kShift);
        return cell == kEnd ? 0x1p128 : double{std::bit_cast<float>(cell << kShift)};
    };
    cells_.reserve(last_cell - first_cell_ + 1);
    double here = function(lower_end(first_cell_));
    least_value_ = most_value_ = function(lower_end(first_cell_ + 1));
    for (std::uint32_t cell = first_cell_; cell <= last_cell; ++cell) {
        const double next = function(lower_end(cell + 1));
        const double slope = (next - here) / static_cast<double>(kFractionBits + 1);
        // Where either end, or the slope between them, would be denormal or infinite: no value.
        constexpr std::uint32_t kFirstNormal = 1u << (23 - kShift);
        const auto is_held = [](double value) { return value == 0.0 || (value > 0x1p-90 && value < 0x1p126); };
        const bool held = cell >= kFirstNormal && is_held(here) && is_held(next);
        const double value = held ? here : std::numeric_limits<double>::quiet_NaN();
        cells_.push_back(std::bit_cast<std::int64_t>(Cell{static_cast<float>(value), static_cast<float>(slope)}));
        here = next;
        least_value_ = std::min(least_value_, next);
        most_value_ = std::max(most_value_, next);
    }
}

}  // namespace emulsion
