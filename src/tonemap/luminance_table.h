#pragma once
// Functions of luminance from tables: the fast path of every operator.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace emulsion {

/// f(x) over [min, max] by linear interpolation between exact values at 64 knots an octave, equally far apart within
/// it. The error is at most h^2 |f''| / 8 where f is smooth, h = x / 64 at most: relative to f, 3.1e-5 |x^2 f'' / f|.
/// Below min and past max the table keeps its ends. NaN where single precision does not reach: for denormal x, which
/// are too far apart, and where f is neither 0 nor in (2^-90, 2^126).
class LuminanceTable {
  public:
    LuminanceTable() = default;  ///< of no function; not to be asked

    /// 0 <= min <= max < 2^128. The function is called on several threads at once; nothing depends on how many.
    LuminanceTable(const std::function<double(double)>& function, double min, double max, int threads);

    static constexpr int kShift = 23 - 6;  ///< 6 bits of a float's significand tell its cell
    static constexpr std::uint32_t kFractionBits = (std::uint32_t{1} << kShift) - 1;  ///< the others: where in the cell

    struct Cell {
        float value = 0.0f;  ///< at its lower end
        float slope = 0.0f;  ///< for each step between floats
    };
    /// f at any float: bits = those of x, held in [least_bits, most_bits], so that what is negative or NaN is past the
    /// largest; cell = cells[(bits >> kShift) - first_cell], the bits of a Cell, which vectors of indices gather at
    /// once; f = cell.value + (bits & kFractionBits) * cell.slope.
    struct View {
        const std::int64_t* cells = nullptr;
        std::uint32_t first_cell = 0, least_bits = 0, most_bits = 0;
    };
    [[nodiscard]] View view() const noexcept { return {cells_.data(), first_cell_, least_bits_, most_bits_}; }

    [[nodiscard]] float operator()(float x) const noexcept {
        const std::uint32_t bits = std::clamp(std::bit_cast<std::uint32_t>(x), least_bits_, most_bits_);
        const auto cell = std::bit_cast<Cell>(cells_[(bits >> kShift) - first_cell_]);
        return cell.value + static_cast<float>(bits & kFractionBits) * cell.slope;
    }

    /// The least and the largest of the values at the knots.
    [[nodiscard]] double least_value() const noexcept { return least_value_; }
    [[nodiscard]] double most_value() const noexcept { return most_value_; }
    /// Whether it has a value for every float.
    [[nodiscard]] bool is_whole() const noexcept { return is_whole_; }

  private:
    std::vector<std::int64_t> cells_;
    std::uint32_t first_cell_ = 0, least_bits_ = 0, most_bits_ = 0;
    double least_value_ = 0.0, most_value_ = 0.0;
    bool is_whole_ = true;
};

}  // namespace emulsion
