#pragma once
// A smooth rising curve of arguments in 0..1 as a table: the fast path of transfer functions.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace emulsion {

/// Parabolas through the curve at the ends and the middle of 64 segments for each octave of the argument, as the float
/// format has them: a power of x, whose slope is infinite at 0, is met as well at 0.01 as at 1, which no table with
/// even steps does. For a power x^p the parabolas are within p |p - 1| |p - 2| 3e-8 of the curve.
class CurveTable {
  public:
    /// \param curve rising on [smallest, 1]
    /// \param smallest where the table starts; in (0, 1)
    CurveTable(const std::function<double(double)>& curve, float smallest);

    /// For x in [smallest, 1]; the value at 1 for every other x, NaN too.
    [[nodiscard]] float operator()(float x) const noexcept {
        const auto bits = std::bit_cast<std::uint32_t>(x);
        const std::uint32_t index = std::min((bits >> kFractionBits) - first_, last_);  // wraps round below `first_`
        const auto t = static_cast<float>(static_cast<std::int32_t>(bits & kFractionMask)) * kPerSegment;
        const Segment& segment = segments_[index];
        return segment.start + t * (segment.linear + t * segment.square);
    }

    static constexpr std::uint32_t kFractionBits = 17;  ///< 23 bits of significand: 6 choose the segment
    static constexpr std::uint32_t kFractionMask = (std::uint32_t{1} << kFractionBits) - 1;
    static constexpr float kPerSegment = 0x1p-17f;

    /// start + t linear + t^2 square, t in [0, 1) over the segment.
    struct alignas(16) Segment {
        float start, linear, square, unused;
    };

    /// The parts, for curve_vectors.h.
    [[nodiscard]] std::uint32_t first() const noexcept { return first_; }
    [[nodiscard]] std::uint32_t last() const noexcept { return last_; }
    [[nodiscard]] const Segment* segments() const noexcept { return segments_.data(); }

  private:
    std::uint32_t first_, last_;  // numbers of the segments of `smallest` and 1, the second less the first
    std::vector<Segment> segments_;
};

}  // namespace emulsion
