#pragma once
// Sums that do not depend on the order of their terms: 128-bit fixed-point numbers.

#include <cmath>
#include <limits>

namespace emulsion {

/// A multiple of 2^-64 in (-2^63, 2^63). Addition is that of integers: associative and commutative, without rounding.
///
/// Range and resolution, for sums of luminances in cd/m^2: the sun's disc has 1.6e9, and 2^32 samples of it sum up to
/// 6.9e18 < 2^63 = 9.2e18. At the other end, 2^-64 = 5.4e-20 is 1e-14 of the darkest night sky that the eye can see
/// (1e-6 to 1e-5), so that a mean of it keeps more digits than a `float` has. A `double` of at least 2^-12 enters
/// exactly; a smaller one is rounded to the nearest multiple.
///
/// A sum that leaves the range stops at its end and stays there, whatever is added: is_saturated(). Order matters only
/// to sums that saturate.
class ExactSum {
  public:
    static constexpr double kResolution = 0x1p-64;
    static constexpr double kLimit = 0x1p63;

    constexpr ExactSum() = default;

    /// The nearest multiple of kResolution (ties to even). Saturated if |value| >= kLimit, and high if it is NaN.
    explicit ExactSum(double value) noexcept {
        if (std::abs(value) < kLimit) {
            units_ = static_cast<Int128>(std::nearbyint(value * kUnitsPerOne));
        } else {
            units_ = value < 0.0 ? kLowest : kHighest;
        }
    }

    ExactSum& operator+=(const ExactSum& other) noexcept {
        if (is_saturated()) return *this;
        if (other.is_saturated() || __builtin_add_overflow(units_, other.units_, &units_)) {
            units_ = other.units_ < 0 ? kLowest : kHighest;
        }
        return *this;
    }

    /// The nearest double.
    [[nodiscard]] double value() const noexcept { return static_cast<double>(units_) * kResolution; }
    [[nodiscard]] bool is_saturated() const noexcept { return units_ == kHighest || units_ == kLowest; }
    bool operator==(const ExactSum&) const = default;

  private:
    __extension__ typedef __int128 Int128;  // NOLINT(modernize-use-using): __extension__ takes no alias
    static constexpr double kUnitsPerOne = 0x1p64;
    static constexpr Int128 kHighest = ~(static_cast<Int128>(1) << 127);
    static constexpr Int128 kLowest = -kHighest;

    Int128 units_ = 0;
};

}  // namespace emulsion
