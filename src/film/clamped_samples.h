#pragma once
// What LuminanceClamp took away.

#include <cstdint>

#include "film/exact_sum.h"

namespace emulsion {

struct ClampedSamples {
    std::uint64_t count = 0;     ///< samples that were scaled down
    ExactSum removed_luminance;  ///< sum of weight * (luminance - what was left of it), cd/m^2 times the imaging ratio

    void merge(const ClampedSamples& other) noexcept {
        count += other.count;
        removed_luminance += other.removed_luminance;
    }
    bool operator==(const ClampedSamples&) const = default;
};

}  // namespace emulsion
