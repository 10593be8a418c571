#pragma once
// How the luminances of a picture are spread: counts in bins of equal ratio, nearly, over all positive floats.

#include <array>
#include <bit>
#include <cstdint>

namespace emulsion {

/// Counts of positive, finite luminances, 32 bins an octave, equally wide within it: a bin is between 1.6 and 3.1 %
/// wide. Counts are integers, so that histograms add to the same result in any order.
class LuminanceHistogram {
  public:
    static constexpr int kBinsPerOctave = 32;
    static constexpr int kBins = 255 * kBinsPerOctave;

    void add(float luminance) noexcept { ++counts_[bin_of(luminance)]; }
    LuminanceHistogram& operator+=(const LuminanceHistogram& other) noexcept;

    [[nodiscard]] std::uint64_t count(int bin) const noexcept { return counts_[static_cast<std::size_t>(bin)]; }
    [[nodiscard]] std::uint64_t total() const noexcept;

    /// The bin's lower end, in the unit of the luminances; bin kBins begins at 2^128.
    [[nodiscard]] static double lower_end(int bin) noexcept;

    /// The luminance below which `rank` of the values lie, 0 <= rank <= total(), values spread evenly over their bin:
    /// within the width of one bin of the value of that rank. 0 if the histogram is empty.
    [[nodiscard]] double value_of_rank(double rank) const noexcept;

    bool operator==(const LuminanceHistogram&) const = default;

  private:
    static constexpr int kShift = 23 - 5;  // of a float's 23 bits of significand, 5 tell its bin

    [[nodiscard]] static std::size_t bin_of(float luminance) noexcept {
        return std::bit_cast<std::uint32_t>(luminance) >> static_cast<unsigned>(kShift);
    }

    std::array<std::uint32_t, kBins> counts_{};
};

}  // namespace emulsion
