#pragma once
// The weights of error diffusion, and how an error is divided by them without remainder.

#include <array>
#include <bit>
#include <cstddef>

namespace emulsion {

/// How whole units come about.
enum class ShareRounding {
    each,  ///< every share is weight * error / divisor, rounded down
    parts  ///< the error is cut into `divisor` parts, rounded down, and a share is as many parts as its weight
};

/// Where the error of a pixel goes: to those ahead in its row, and to two rows below.
struct DiffusionKernel {
    int divisor;  ///< of the weights
    ShareRounding rounding;
    std::array<std::array<int, 5>, 3> weights;  ///< rows downward from the pixel's own; from 2 behind it to 2 ahead

    /// Of the pixel `dx` ahead (from -2 to 2) and `dy` below (from 0 to 2).
    [[nodiscard]] constexpr int weight(int dx, int dy) const noexcept {
        const int column = dx + 2;
        return weights[static_cast<std::size_t>(dy)][static_cast<std::size_t>(column)];
    }
    /// Of all weights; less than the divisor if some of the error is not handed on.
    [[nodiscard]] constexpr int total() const noexcept {
        int sum = 0;
        for (const auto& row : weights) {
            for (const int weight : row) sum += weight;
        }
        return sum;
    }
    /// Columns to either side that errors reach, 1 or 2; so many rows below, too.
    [[nodiscard]] constexpr int reach() const noexcept { return weights[2] == std::array<int, 5>{} ? 1 : 2; }

    /// What of an error the neighbours get together.
    template <class Int>
    [[nodiscard]] constexpr Int handed_on(Int error) const noexcept {
        return total() == divisor ? error : floor_quotient(static_cast<Int>(error * total()));
    }
    /// error / divisor, rounded down.
    template <class Int>
    [[nodiscard]] constexpr Int floor_quotient(Int error) const noexcept {
        if (std::has_single_bit(static_cast<unsigned>(divisor))) {
            return error >> std::countr_zero(static_cast<unsigned>(divisor));
        }
        return error / divisor - (error % divisor < 0 ? 1 : 0);
    }
    /// What the neighbour of this weight gets where all are there. The pixel below gets what the others leave.
    template <class Int>
    [[nodiscard]] constexpr Int share(Int error, int weight) const noexcept {
        return rounding == ShareRounding::each ? floor_quotient(static_cast<Int>(error * weight))
                                               : floor_quotient(error) * weight;
    }
};

/// Source: Floyd & Steinberg, "An Adaptive Algorithm for Spatial Greyscale", Proc. SID 17 (1976).
inline constexpr DiffusionKernel kFloydSteinbergKernel = {
    16, ShareRounding::each, {{{0, 0, 0, 7, 0}, {0, 3, 5, 1, 0}, {}}}};
/// Source: Jarvis, Judice & Ninke, "A Survey of Techniques for the Display of Continuous Tone Pictures on Bilevel
/// Displays", Computer Graphics and Image Processing 5 (1976).
inline constexpr DiffusionKernel kJarvisKernel = {
    48, ShareRounding::parts, {{{0, 0, 0, 7, 5}, {3, 5, 7, 5, 3}, {1, 3, 5, 3, 1}}}};
/// Source: Stucki, "MECCA - a Multiple-Error Correction Computation Algorithm for Bilevel Image Hardcopy Reproduction",
/// IBM Research Report RZ1060 (1981).
inline constexpr DiffusionKernel kStuckiKernel = {
    42, ShareRounding::parts, {{{0, 0, 0, 8, 4}, {2, 4, 8, 4, 2}, {1, 2, 4, 2, 1}}}};
/// Source: Sierra, in a file of CompuServe's graphics forum (1989); of three rows.
inline constexpr DiffusionKernel kSierraKernel = {
    32, ShareRounding::parts, {{{0, 0, 0, 5, 3}, {2, 4, 5, 4, 2}, {0, 2, 3, 2, 0}}}};
/// Source: Atkinson, as HyperScan for the Macintosh had it (1987).
inline constexpr DiffusionKernel kAtkinsonKernel = {
    8, ShareRounding::parts, {{{0, 0, 0, 1, 1}, {0, 1, 1, 1, 0}, {0, 0, 1, 0, 0}}}};

/// The neighbours that a pixel near the border has.
class DiffusionNeighbours {
  public:
    struct Neighbour {
        int dx, dy, weight;
    };

    /// With so many columns behind and ahead and rows below; more than 2 is as 2.
    constexpr DiffusionNeighbours(const DiffusionKernel& kernel, int behind, int ahead, int below) noexcept {
        for (int dy = 0; dy <= 2 && dy <= below; ++dy) {
            for (int dx = -2; dx <= 2; ++dx) {
                const int weight = kernel.weight(dx, dy);
                if (weight == 0 || -dx > behind || dx > ahead) continue;
                total_ += weight;
                const bool is_rest = below > 0 ? dx == 0 && dy == 1 : dx == 1;
                if (is_rest) {
                    rest_ = {dx, dy, weight};
                } else {
                    others_[static_cast<std::size_t>(count_++)] = {dx, dy, weight};
                }
            }
        }
        all_there_ = total_ == kernel.total();
    }

    /// Calls give(dx, dy, share) for every neighbour. Where all of them are there, shares are the kernel's; at the
    /// border, those outside leave theirs to those inside, in proportion to the weights and rounded toward 0. The pixel
    /// below (in the last row: the next one) gets what the others leave, so that nothing is lost between them.
    template <class Int, class Give>
    constexpr void hand_on(const DiffusionKernel& kernel, Int error, const Give& give) const noexcept {
        if (total_ == 0) return;
        const Int handed = kernel.handed_on(error);
        Int rest = handed;
        for (int i = 0; i < count_; ++i) {
            const Neighbour& to = others_[static_cast<std::size_t>(i)];
            const Int share =
                all_there_ ? kernel.share(error, to.weight) : static_cast<Int>(handed * to.weight / total_);
            give(to.dx, to.dy, share);
            rest -= share;
        }
        give(rest_.dx, rest_.dy, rest);
    }

  private:
    std::array<Neighbour, 12> others_{};
    Neighbour rest_{};
    int count_ = 0, total_ = 0;
    bool all_there_ = false;
};

}  // namespace emulsion
