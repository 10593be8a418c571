#pragma once
// What gamut mapping found.

#include <algorithm>
#include <cstdint>

namespace emulsion {

/// How far outside [0, 1] a component may lie before its pixel counts as outside: rounding in the matrix that made it
/// reaches 6e-7.
inline constexpr float kGamutTolerance = 0x1p-20f;

struct GamutCounts {
    std::int64_t outside = 0;     ///< pixels with a component outside [0, 1] by more than the tolerance
    std::int64_t nan = 0;         ///< pixels with a NaN component; not counted as outside
    float largest_excess = 0.0f;  ///< largest distance of a component from [0, 1], linear; may be +Inf
    std::int64_t uncoded = 0;     ///< pixels inside that HLG has no code for, brought to one: see hlg_scene_light()

    GamutCounts& operator+=(const GamutCounts& b) noexcept {
        outside += b.outside;
        nan += b.nan;
        largest_excess = std::max(largest_excess, b.largest_excess);
        uncoded += b.uncoded;
        return *this;
    }
    bool operator==(const GamutCounts&) const = default;
};

}  // namespace emulsion
