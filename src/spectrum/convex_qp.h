#pragma once
// Small convex quadratic programs, for the bases of RGB uplifts: minimise x'Hx/2 + g'x over the x for which Ax = b and
// Gx >= h.

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace emulsion {

/// A dense matrix by rows.
using DenseMatrix = std::vector<std::vector<double>>;

/// Sum of coefficient * x[index] over the terms >= bound.
struct QpInequality {
    std::vector<std::pair<std::size_t, double>> terms;
    double bound = 0.0;
};

struct QuadraticProgram {
    DenseMatrix hessian;                     ///< n x n, symmetric, positive semidefinite; elements about 1
    std::vector<double> gradient;            ///< n
    DenseMatrix equalities;                  ///< rows of n, linearly independent; elements of at most about 1
    std::vector<double> equality_values;     ///< as many
    std::vector<QpInequality> inequalities;  ///< at least one; each x is bounded by some, or by the hessian
};

/// The minimum: inequalities and equalities hold to 1e-10 or better, usually to rounding. Unset if no x satisfies them
/// all, or only with no room to spare in some inequality that isn't an equality.
/// By a primal-dual interior point method with Mehrotra's predictor and corrector.
/// Source: Nocedal & Wright, "Numerical Optimization", 2nd ed., 2006, algorithm 16.4; started from x = `start`.
[[nodiscard]] std::optional<std::vector<double>> minimise(const QuadraticProgram& program,
                                                          const std::vector<double>& start);

}  // namespace emulsion
