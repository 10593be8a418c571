#pragma once
// What the pixels of all films have.

#include <cstdint>
#include <limits>

#include "core/color.h"

namespace emulsion {

/// Sums over the samples of a pixel, as doubles.
struct WeightedSums {
    XYZd xyz;             ///< of weight * XYZ
    double weight = 0.0;  ///< of the weights
    bool operator==(const WeightedSums&) const = default;
};

/// Counts up to 2^32 - 1, and stays there.
class SampleCount {
  public:
    static constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();

    void add(std::uint32_t samples) noexcept { count_ = samples > kMost - count_ ? kMost : count_ + samples; }
    [[nodiscard]] std::uint32_t count() const noexcept { return count_; }
    [[nodiscard]] bool is_saturated() const noexcept { return count_ == kMost; }
    bool operator==(const SampleCount&) const = default;

  private:
    std::uint32_t count_ = 0;
};

}  // namespace emulsion
