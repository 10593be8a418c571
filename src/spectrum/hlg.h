#pragma once
// Hybrid log-gamma (HLG), the camera curve of high dynamic range television.

#include <string_view>

namespace emulsion {

/// encode(x) = sqrt(3 x) for x <= 1/12, a ln(12 x - b) + c above; a = 0.17883277, b = 1 - 4a, c = 0.5 - a ln(4a).
/// Linear is light in the scene, 1 the brightest that is encoded: the curve of the camera (OETF), without the
/// display's system gamma (OOTF).
/// Source: ITU-R BT.2100-2, table 5. The pieces meet exactly, at code 0.5 and with one slope. As a is rounded, 1 is
/// encoded as 1 - 4.9e-9.
struct HlgTransfer {
    static constexpr std::string_view kName = "hlg";
    static constexpr std::string_view kHelp = "hybrid log-gamma of BT.2100, scene light";
    static constexpr double kLinearKnee = 1.0 / 12.0;  ///< the last value of the square root
    static constexpr double kEncodedKnee = 0.5;
    bool operator==(const HlgTransfer&) const = default;
};

[[nodiscard]] double encode(const HlgTransfer& transfer, double linear) noexcept;
[[nodiscard]] double decode(const HlgTransfer& transfer, double encoded) noexcept;

/// The logarithm alone, for any linear > b / 12 = 0.0237.
[[nodiscard]] double encode_above_knee(const HlgTransfer& transfer, double linear) noexcept;

}  // namespace emulsion
