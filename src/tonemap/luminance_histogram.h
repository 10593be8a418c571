#pragma once
// How the luminances of a picture are spread: counts and means in bins of equal ratio, nearly, over all positive
// floats.

#include <array>
#include <bit>
#include <cstdint>

namespace emulsion {

/// Positive, finite luminances, 32 bins an octave, equally wide within it: a bin is between 1.6 and 3.1 % wide, among
/// denormals, too, which have fewer digits than that from 32 of the least one downwards. Counts and means are made of
/// integers, so that histograms add to the same result in any order. A bin holds up to 2^27 values.
class LuminanceHistogram {
  public:
    static constexpr int kBinsPerOctave = 32;
    static constexpr int kDenormalOctaves = 23, kNormalOctaves = 254;
    static constexpr int kBins = (kDenormalOctaves + kNormalOctaves) * kBinsPerOctave;
    static constexpr std::uint64_t kMostValues = std::uint64_t{1} << 27u;

    void add(float luminance) noexcept {
        auto bits = std::bit_cast<std::uint32_t>(luminance);
        auto exponent_offset = kNormalOffset;
        if (bits < kLeastNormalBits) {  // a denormal is that whole number of least ones
            bits = std::bit_cast<std::uint32_t>(static_cast<float>(bits));
            exponent_offset = kDenormalOffset;
        }
        cells_[(bits >> kShift) + exponent_offset] += kOne + (bits >> kDroppedBits & kMostPlace);
    }
    LuminanceHistogram& operator+=(const LuminanceHistogram& other) noexcept;

    [[nodiscard]] std::uint64_t count(int bin) const noexcept { return cell(bin) >> kPlaceSumBits; }
    [[nodiscard]] std::uint64_t total() const noexcept;

    /// The mean of a bin that is not empty, to 3e-5 of it.
    [[nodiscard]] double mean(int bin) const noexcept;

    /// The bin's lower end, in the unit of the luminances, from 2^-149 on; bin kBins begins at 2^128.
    [[nodiscard]] static double lower_end(int bin) noexcept;

    /// The luminance below which `rank` of the values lie, 0 <= rank <= total(): at the middle of a bin's ranks its
    /// mean, between two bins the mean of both, and linear from one to the other. Next to an empty bin it stays at the
    /// mean. So values of one bin count as equal, a gap stays one, and one value more moves little; it is within the
    /// width of one bin of the value of that rank. 0 if the histogram is empty.
    [[nodiscard]] double value_of_rank(double rank) const noexcept;

    bool operator==(const LuminanceHistogram&) const = default;

  private:
    static constexpr unsigned kShift = 23 - 5;  // of a float's 23 bits of significand, 5 tell its bin
    // The next 10 tell its place in the bin. A cell is a count and, below it, the sum of places.
    static constexpr unsigned kPlaceBits = 10, kDroppedBits = kShift - kPlaceBits, kPlaceSumBits = 37;
    static constexpr std::uint64_t kMostPlace = (std::uint64_t{1} << kPlaceBits) - 1;
    static constexpr std::uint64_t kOne = std::uint64_t{1} << kPlaceSumBits;

    // From the upper bits of a float, or of how many least ones a denormal is, to the bin, modulo 2^32.
    static constexpr std::uint32_t kLeastNormalBits = std::uint32_t{1} << 23u;
    static constexpr std::uint32_t kNormalOffset = (kDenormalOctaves - 1) * kBinsPerOctave;
    static constexpr std::uint32_t kDenormalOffset = 0u - 127u * kBinsPerOctave;

    [[nodiscard]] std::uint64_t cell(int bin) const noexcept { return cells_[static_cast<std::size_t>(bin)]; }

    std::array<std::uint64_t, kBins> cells_{};
};

}  // namespace emulsion
