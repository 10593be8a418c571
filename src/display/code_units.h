#pragma once
// Values between codes, as whole numbers: what every dither reckons with.

#include <algorithm>
#include <bit>
#include <cstdint>

#include "display/code_value.h"

namespace emulsion {

/// A value is a whole number of units above black. There are 2^16 of them to a code, and fewer where that would be
/// finer than single precision just below 1: then the float nearest to a code is exactly that code here.
/// Values are below 2^24, for all scales.
class CodeUnits {
  public:
    explicit constexpr CodeUnits(const CodeScale& scale) noexcept
        : fraction_bits_(std::min(16, 24 - static_cast<int>(std::bit_width(static_cast<unsigned>(scale.steps()))))),
          white_(scale.steps() << fraction_bits_) {}

    [[nodiscard]] constexpr int fraction_bits() const noexcept { return fraction_bits_; }
    [[nodiscard]] constexpr std::int32_t per_code() const noexcept { return 1 << fraction_bits_; }
    /// The units of encoded 1.
    [[nodiscard]] constexpr std::int32_t white() const noexcept { return white_; }

    /// To the nearest unit, halves up; what lies outside [0, 1] as unit_clamp() has it.
    [[nodiscard]] constexpr std::int32_t operator()(float encoded) const noexcept {
        // NOLINTNEXTLINE(bugprone-incorrect-roundings): not negative, and exact in double precision up to the cut
        return static_cast<std::int32_t>(static_cast<double>(unit_clamp(encoded)) * white_ + 0.5);
    }

  private:
    int fraction_bits_;
    std::int32_t white_;
};

}  // namespace emulsion
