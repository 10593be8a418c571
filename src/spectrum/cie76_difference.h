#pragma once
// Colour difference of 1976. See spectrum/color_difference.h.

#include <string_view>

#include "spectrum/cielab.h"

namespace emulsion {

/// Euclidean distance in CIELAB. Overrates differences of saturated colours several times.
/// Source: CIE 15:2004, section 8.2.
struct Cie76Difference {
    static constexpr std::string_view kName = "cie76";
    static constexpr std::string_view kHelp = "distance in CIELAB";
    bool operator==(const Cie76Difference&) const = default;
};

/// Symmetric.
[[nodiscard]] double difference(const Cie76Difference& method, const Lab& reference, const Lab& sample) noexcept;

}  // namespace emulsion
