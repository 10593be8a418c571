#pragma once
// The perceptual quantizer (PQ) of high dynamic range displays.

#include <string_view>

namespace emulsion {

/// With y = x^m1: encode(x) = ((c1 + c2 y) / (1 + c3 y))^m2; m1 = 2610/16384, m2 = 2523/32, c1 = 107/128,
/// c2 = 2413/128, c3 = 2392/128. Linear is the luminance shown, over 10000 cd/m^2 (kPeak_cdm2), encoded 1.
/// Source: SMPTE ST 2084:2014, ITU-R BT.2100-2, table 4.
/// As standardised, 0 is encoded as c1^m2 = 7.31e-7, 0.05 of a 16-bit code; codes below that decode to 0.
/// Past 1 the formula goes on: codes end at (c2/c3)^m2 = 1.9921 for infinite light, and those above it decode to
/// infinity. Negative values by f(-x) = -f(x), with a step from -7.31e-7 to 7.31e-7 at 0.
struct PqTransfer {
    static constexpr std::string_view kName = "pq";
    static constexpr std::string_view kHelp = "SMPTE ST 2084, linear 1 is 10000 cd/m^2";
    static constexpr double kPeak_cdm2 = 10000.0;
    bool operator==(const PqTransfer&) const = default;
};

[[nodiscard]] double encode(const PqTransfer& transfer, double linear) noexcept;
[[nodiscard]] double decode(const PqTransfer& transfer, double encoded) noexcept;

}  // namespace emulsion
