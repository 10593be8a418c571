#pragma once
// From n samples of an axis to half as many and back, so that no light is lost on the way, for every n.

#include <array>
#include <cstddef>
#include <vector>

namespace emulsion {

/// n samples and m = ceil(n / 2) wider ones over the same length. Going down, samples are smoothed by [1 2 1] / 4, the
/// axis being mirrored at its ends, and averaged over the length n / m of each wider one; going up is the transposed of
/// that: for even n, the weights [1 3 3 1] / 8 both ways. A constant stays as it is both ways, and so does the sum of
/// samples times their length.
class AxisHalving {
  public:
    /// Weights of neighbouring samples.
    struct Taps {
        int first = 0, count = 0;
        std::array<float, 5> weights{};
    };

    explicit AxisHalving(int size);  ///< >= 1

    [[nodiscard]] int size() const noexcept { return static_cast<int>(up_.size()); }
    [[nodiscard]] int half_size() const noexcept { return static_cast<int>(down_.size()); }
    /// Length of a wider sample in samples: in [1.5, 2], or 1 if there is but one sample.
    [[nodiscard]] double spacing() const noexcept { return double(size()) / half_size(); }
    /// By how much going down and up again spreads, in samples^2.
    [[nodiscard]] double variance() const noexcept;

    [[nodiscard]] const Taps& down(int half) const noexcept { return down_[static_cast<std::size_t>(half)]; }
    [[nodiscard]] const Taps& up(int full) const noexcept { return up_[static_cast<std::size_t>(full)]; }

  private:
    std::vector<Taps> down_;  ///< of each wider sample, over samples
    std::vector<Taps> up_;    ///< of each sample, over wider ones
};

/// An axis at one of the levels that come of halving it again and again.
struct LevelAxis {
    AxisHalving halving;        ///< to the next level
    double scale_px = 1.0;      ///< length of a sample
    double variance_px2 = 0.0;  ///< by how much coming here and going back spreads

    explicit LevelAxis(int size) : halving(size) {}
    [[nodiscard]] LevelAxis next() const;

    /// The variance in samples^2 that is left to blur by at this level, so that coming here, gaussian_kernel() of that
    /// variance, and going back spread as far as gaussian_kernel() of `sigma_px` at the first level. Negative: they
    /// spread farther without it. 0 if there is but one sample.
    [[nodiscard]] double remaining_variance(double sigma_px) const noexcept;
};

}  // namespace emulsion
