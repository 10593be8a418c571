#include "spectrum/sigmoid_table_solver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "spectrum/sigmoid.h"
#include "spectrum/sigmoid_solver.h"
#include "spectrum/sigmoid_table.h"

namespace emulsion {

namespace {

using Vector3 = std::array<double, 3>;

// Stands for black: small enough that the scaled coefficients have reached their limit.
constexpr double kDarkest = 1e-5;

// Coefficient of white, which would be infinite. Below it, greys to 1 - 2.5e-7 keep theirs.
constexpr double kWhiteCoefficient = 1000.0;

// A coefficient of 100 (an edge some ten nanometres wide, in a light colour) costs a difference of one CIELAB unit.
constexpr double kPenalty = 1e-4;

class TableSolver {
  public:
    TableSolver(const ReflectanceWeights& xyz_weights, const Matrix3& relative_xyz_from_rgb, int resolution)
        : xyz_weights_(xyz_weights),
          relative_xyz_from_rgb_(relative_xyz_from_rgb),
          nodes_(static_cast<std::size_t>(resolution)),
          scaled_(3 * nodes_ * nodes_ * nodes_) {}

    // From grey, where x = y = 1, to the most saturated colours; along z from the middle to both ends.
    [[nodiscard]] std::vector<float> solve() {
        for (std::size_t largest = 0; largest < 3; ++largest) {
            for (std::size_t y = nodes_; y-- > 0;) {
                for (std::size_t x = nodes_; x-- > 0;) solve_along_z(largest, x, y);
            }
        }
        std::vector<float> table;
        table.reserve(3 * scaled_.size());
        for (const Vector3& k : scaled_) {
            for (const double coefficient : k) table.push_back(static_cast<float>(coefficient));
        }
        return table;
    }

  private:
    [[nodiscard]] Vector3& at(std::size_t largest, std::size_t x, std::size_t y, std::size_t z) {
        return scaled_[((largest * nodes_ + z) * nodes_ + y) * nodes_ + x];
    }

    [[nodiscard]] double value(std::size_t node) const noexcept {
        return sigmoid_table_value(static_cast<double>(node) / static_cast<double>(nodes_ - 1));
    }

    void solve_along_z(std::size_t largest, std::size_t x, std::size_t y) {
        const std::size_t middle = nodes_ / 2, last = nodes_ - 1;
        Vector3 start{};
        if (x < last) {
            start = at(largest, x + 1, y, middle);
        } else if (y < last) {
            start = at(largest, x, y + 1, middle);
        }
        solve_node(largest, x, y, middle, start);
        for (std::size_t z = middle + 1; z < nodes_; ++z) solve_node(largest, x, y, z, at(largest, x, y, z - 1));
        for (std::size_t z = middle; z-- > 0;) solve_node(largest, x, y, z, at(largest, x, y, z + 1));
    }

    void solve_node(std::size_t largest, std::size_t x, std::size_t y, std::size_t z, const Vector3& start) {
        const double maximum = std::max(value(z), kDarkest), root = std::sqrt(maximum);
        Vector3 k = {0.0, 0.0, maximum < 1.0 ? inverse_sigmoid(maximum) : kWhiteCoefficient};
        if (x + 1 < nodes_ || y + 1 < nodes_) {
            Vector3 rgb{};
            rgb[largest] = maximum;
            rgb[(largest + 1) % 3] = maximum * value(x);
            rgb[(largest + 2) % 3] = maximum * value(y);
            const Vector3 xyz = relative_xyz_from_rgb_ * rgb;
            const SigmoidSearch search = {
                .start = {sigmoid_from_centred({start[0] / root, start[1] / root, start[2] / root})},
                .accepted_difference = 1e-4,
                .least_gain = 1e-6,
                .penalty = kPenalty * maximum,  // of the scaled coefficients
                .evaluations = 60};
            k = centred_from_sigmoid(improved_sigmoid(xyz_weights_, {xyz[0], xyz[1], xyz[2]}, search).c);
        }
        at(largest, x, y, z) = {root * k[0], root * k[1], root * k[2]};
    }

    const ReflectanceWeights& xyz_weights_;
    const Matrix3& relative_xyz_from_rgb_;
    std::size_t nodes_;
    std::vector<Vector3> scaled_;  // times sqrt(z)
};

}  // namespace

std::vector<float> solve_sigmoid_table(const ReflectanceWeights& xyz_weights, const Matrix3& relative_xyz_from_rgb,
                                       int resolution) {
    return TableSolver(xyz_weights, relative_xyz_from_rgb, resolution).solve();
}

}  // namespace emulsion
