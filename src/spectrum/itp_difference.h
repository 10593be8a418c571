#pragma once
// Colour difference for high dynamic range, of two ICtCp colours. It is absolute: the same pair in other light has
// another difference. The differences of CIELAB colours are in spectrum/color_difference.h.

#include <string_view>

#include "spectrum/ictcp.h"

namespace emulsion {

/// dE_ITP = 720 sqrt(dI^2 + (dCt / 2)^2 + dCp^2); 1 is just seen by the most sensitive eyes. Symmetric; NaN in a colour
/// gives NaN. Source: ITU-R BT.2124-0, annex 1.
struct ItpDifference {
    static constexpr std::string_view kName = "itp";
    static constexpr std::string_view kHelp = "BT.2124 for high dynamic range, of ICtCp";
    bool operator==(const ItpDifference&) const = default;
};

[[nodiscard]] double difference(const ItpDifference& method, const ICtCp& reference, const ICtCp& sample) noexcept;

}  // namespace emulsion
