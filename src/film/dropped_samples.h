#pragma once
// Samples that a film keeps out, because one of them would spoil its pixel: how many, of which kind, and the first few.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "core/color.h"

namespace emulsion {

/// Why a sample was kept out: a NaN among its values, its luminance and its weight; else an infinity; else a luminance
/// below 0 (before the weight, which may well be negative).
enum class DroppedKind { nan, infinite, negative_luminance };

/// Of a sample that is kept out, by all of its numbers.
[[nodiscard]] DroppedKind kind_of_dropped(std::span<const float> numbers) noexcept;

struct DroppedSample {
    int x_px = 0, y_px = 0;  ///< the pixel, in the film's coordinates
    DroppedKind kind = DroppedKind::nan;
    XYZ value;  ///< before the weight
    float weight = 0.0f;
};

/// "pixel (3, 4): XYZ (nan, 1, 1), weight 1: not a number"
[[nodiscard]] std::string to_string(const DroppedSample& sample);

class DroppedSamples {
  public:
    static constexpr std::size_t kReported = 8;

    [[nodiscard]] std::uint64_t count() const noexcept { return counts_[0] + counts_[1] + counts_[2]; }
    [[nodiscard]] std::uint64_t count(DroppedKind kind) const noexcept {
        return counts_[static_cast<std::size_t>(kind)];
    }

    /// The first kReported of them in reading order (row, then column; then kind and numbers), whatever the order in
    /// which they came.
    [[nodiscard]] std::span<const DroppedSample> first() const noexcept { return {first_.data(), first_count_}; }

    /// Counts a sample whose kind is set.
    void add(const DroppedSample& sample) noexcept;
    void merge(const DroppedSamples& other) noexcept;

    /// As another object reported it: for reading from files. At most kReported samples, in reading order.
    /// \throws std::invalid_argument if there are more of them, in another order, or more of a kind than are counted.
    [[nodiscard]] static DroppedSamples restored(const std::array<std::uint64_t, 3>& counts,
                                                 std::span<const DroppedSample> first);

    /// Counts and first samples are the same, bit for bit.
    friend bool operator==(const DroppedSamples& a, const DroppedSamples& b) noexcept;

  private:
    std::array<std::uint64_t, 3> counts_{};  // by kind
    std::array<DroppedSample, kReported> first_{};
    std::size_t first_count_ = 0;
};

}  // namespace emulsion
