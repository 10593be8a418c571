#pragma once
// The mean of numbers that come one by one, and how far off it may be.

#include <cmath>

namespace emulsion::testing {

/// Source of the update: Welford, "Note on a Method for Calculating Corrected Sums of Squares and Products",
/// Technometrics 4(3), 1962.
class Mean {
  public:
    void add(double value) noexcept {
        count_ += 1.0;
        const double change = value - mean_;
        mean_ += change / count_;
        squares_ += change * (value - mean_);
    }
    [[nodiscard]] double value() const noexcept { return mean_; }
    /// NaN of fewer than two numbers.
    [[nodiscard]] double standard_error() const noexcept { return std::sqrt(squares_ / (count_ * (count_ - 1.0))); }

  private:
    double count_ = 0.0, mean_ = 0.0, squares_ = 0.0;
};

}  // namespace emulsion::testing
