#include "spectrum/convex_qp.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace emulsion {

namespace {

using Vector = std::vector<double>;

double dot(const Vector& a, const Vector& b) noexcept {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

// Infinite if an element is not finite.
double largest(const Vector& v) noexcept {
    double result = 0.0;
    for (const double x : v) {
        if (!std::isfinite(x)) return std::numeric_limits<double>::infinity();
        result = std::max(result, std::abs(x));
    }
    return result;
}

// Cholesky's factor of a positive definite matrix. Zeros before the first element of a row stay, and are passed over:
// matrices with a narrow band take little time.
class Cholesky {
  public:
    explicit Cholesky(DenseMatrix matrix) : lower_(std::move(matrix)), first_(lower_.size()) {
        for (std::size_t i = 0; i < lower_.size(); ++i) {
            while (first_[i] < i && lower_[i][first_[i]] == 0.0) ++first_[i];
            for (std::size_t j = first_[i]; j <= i; ++j) {
                double element = lower_[i][j];
                for (std::size_t k = std::max(first_[i], first_[j]); k < j; ++k) element -= lower_[i][k] * lower_[j][k];
                // Rounding may leave nothing of a diagonal element: then its unknown is left alone.
                lower_[i][j] = i == j ? std::sqrt(std::max(element, 1e-300)) : element / lower_[j][j];
            }
        }
    }

    [[nodiscard]] Vector solve(Vector x) const {
        for (std::size_t i = 0; i < x.size(); ++i) {
            for (std::size_t k = first_[i]; k < i; ++k) x[i] -= lower_[i][k] * x[k];
            x[i] /= lower_[i][i];
        }
        for (std::size_t i = x.size(); i-- > 0;) {
            x[i] /= lower_[i][i];
            for (std::size_t k = first_[i]; k < i; ++k) x[k] -= lower_[i][k] * x[i];
        }
        return x;
    }

  private:
    DenseMatrix lower_;
    std::vector<std::size_t> first_;
};

// x, the multipliers of the equalities, the slack and the multipliers of the inequalities (both > 0). Also a step.
struct Point {
    Vector x, equality, slack, inequality;
};

// What must vanish: the gradient of the Lagrangian, and how far equalities and slacks are off.
struct Residual {
    Vector dual, equality, slack;
};

class InteriorPoint {
  public:
    InteriorPoint(const QuadraticProgram& program, const Vector& start)
        : program_(program),
          at_{start, Vector(program.equalities.size()), Vector(program.inequalities.size()),
              Vector(program.inequalities.size(), 1.0)} {
        const Vector above = above_bounds(at_.x);
        for (std::size_t i = 0; i < above.size(); ++i) at_.slack[i] = std::max(above[i], 0.1);
    }

    [[nodiscard]] std::optional<Vector> minimise() {
        constexpr int kMaxIterations = 100;
        constexpr double kTolerance = 1e-12, kAcceptable = 1e-10;
        for (int i = 0; i < kMaxIterations; ++i) {
            const Residual residual = residual_here();
            const double infeasibility = std::max(largest(residual.equality), largest(residual.slack));
            const double error = std::max({infeasibility, largest(residual.dual), gap()});
            if (error < kTolerance) return at_.x;
            if (!std::isfinite(error)) return std::nullopt;  // multipliers grow without bound if nothing is feasible
            if (!improve(residual)) return infeasibility < kAcceptable ? std::optional(at_.x) : std::nullopt;
        }
        const Residual residual = residual_here();
        const bool feasible = std::max(largest(residual.equality), largest(residual.slack)) < kAcceptable;
        return feasible ? std::optional(at_.x) : std::nullopt;
    }

  private:
    // Mean product of slacks and multipliers: 0 at the minimum.
    [[nodiscard]] double gap() const { return dot(at_.slack, at_.inequality) / static_cast<double>(at_.slack.size()); }

    // Gx - h
    [[nodiscard]] Vector above_bounds(const Vector& x) const {
        Vector result;
        result.reserve(program_.inequalities.size());
        for (const QpInequality& inequality : program_.inequalities) {
            result.push_back(sum_of(inequality, x) - inequality.bound);
        }
        return result;
    }

    [[nodiscard]] static double sum_of(const QpInequality& inequality, const Vector& x) {
        double sum = 0.0;
        for (const auto& [index, coefficient] : inequality.terms) sum += coefficient * x[index];
        return sum;
    }

    // v + G' times y
    [[nodiscard]] Vector plus_transposed(Vector v, const Vector& y) const {
        for (std::size_t i = 0; i < y.size(); ++i) {
            for (const auto& [index, coefficient] : program_.inequalities[i].terms) v[index] += coefficient * y[i];
        }
        return v;
    }

    [[nodiscard]] Residual residual_here() const {
        Residual residual{program_.gradient, {}, above_bounds(at_.x)};
        for (std::size_t i = 0; i < at_.x.size(); ++i) residual.dual[i] += dot(program_.hessian[i], at_.x);
        for (std::size_t j = 0; j < program_.equalities.size(); ++j) {
            residual.equality.push_back(dot(program_.equalities[j], at_.x) - program_.equality_values[j]);
            for (std::size_t i = 0; i < at_.x.size(); ++i) {
                residual.dual[i] -= program_.equalities[j][i] * at_.equality[j];
            }
        }
        Vector minus(at_.inequality);
        for (double& m : minus) m = -m;
        residual.dual = plus_transposed(std::move(residual.dual), minus);
        for (std::size_t i = 0; i < at_.slack.size(); ++i) residual.slack[i] -= at_.slack[i];
        return residual;
    }

    // Newton's equations, reduced to x and the equalities' multipliers; factored once for both steps.
    struct Factors {
        Cholesky reduced;                // K = H + G' (multiplier/slack) G
        DenseMatrix reduced_equalities;  // rows of A K^-1
        Cholesky schur;                  // A K^-1 A'
    };

    [[nodiscard]] Factors factors_here() const {
        DenseMatrix reduced = program_.hessian;
        for (std::size_t i = 0; i < at_.slack.size(); ++i) {
            const auto& terms = program_.inequalities[i].terms;
            for (const auto& [row, a] : terms) {
                for (const auto& [column, b] : terms) reduced[row][column] += a * b * at_.inequality[i] / at_.slack[i];
            }
        }
        Cholesky factor(std::move(reduced));
        const DenseMatrix& a = program_.equalities;
        DenseMatrix solved;
        solved.reserve(a.size());
        for (const Vector& row : a) solved.push_back(factor.solve(row));
        DenseMatrix schur(a.size(), Vector(a.size()));
        for (std::size_t i = 0; i < a.size(); ++i) {
            for (std::size_t j = 0; j < a.size(); ++j) schur[i][j] = dot(a[i], solved[j]);
        }
        return {std::move(factor), std::move(solved), Cholesky(std::move(schur))};
    }

    // The step to where the residual vanishes and slack * multiplier = 0 for `complementarity` = slack * multiplier.
    [[nodiscard]] Point newton_step(const Factors& factors, const Residual& residual,
                                    const Vector& complementarity) const {
        Vector inner(at_.slack.size());
        for (std::size_t i = 0; i < inner.size(); ++i) {
            inner[i] = -(complementarity[i] + at_.inequality[i] * residual.slack[i]) / at_.slack[i];
        }
        Vector right(residual.dual);
        for (double& r : right) r = -r;
        right = plus_transposed(std::move(right), inner);

        Vector schur_right;
        for (std::size_t j = 0; j < residual.equality.size(); ++j) {
            schur_right.push_back(-residual.equality[j] - dot(factors.reduced_equalities[j], right));
        }
        Point step;
        step.equality = factors.schur.solve(std::move(schur_right));
        step.x = factors.reduced.solve(std::move(right));
        for (std::size_t j = 0; j < step.equality.size(); ++j) {
            for (std::size_t i = 0; i < step.x.size(); ++i) {
                step.x[i] += factors.reduced_equalities[j][i] * step.equality[j];
            }
        }
        for (std::size_t i = 0; i < at_.slack.size(); ++i) {
            step.slack.push_back(sum_of(program_.inequalities[i], step.x) + residual.slack[i]);
            step.inequality.push_back(-(complementarity[i] + at_.inequality[i] * step.slack[i]) / at_.slack[i]);
        }
        return step;
    }

    // How many times a step can be taken before a slack or a multiplier is 0; may be infinite.
    [[nodiscard]] double longest(const Point& step) const {
        double length = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < at_.slack.size(); ++i) {
            if (step.slack[i] < 0.0) length = std::min(length, -at_.slack[i] / step.slack[i]);
            if (step.inequality[i] < 0.0) length = std::min(length, -at_.inequality[i] / step.inequality[i]);
        }
        return length;
    }

    // One predictor and corrector step. False when steps have become too short to get anywhere.
    bool improve(const Residual& residual) {
        const Factors factors = factors_here();
        Vector complementarity(at_.slack.size());
        for (std::size_t i = 0; i < complementarity.size(); ++i) {
            complementarity[i] = at_.slack[i] * at_.inequality[i];
        }
        const Point predictor = newton_step(factors, residual, complementarity);

        // How much of the gap the predictor would close says how far to aim.
        const double predicted = std::min(1.0, longest(predictor));
        double predicted_gap = 0.0;
        for (std::size_t i = 0; i < complementarity.size(); ++i) {
            predicted_gap += (at_.slack[i] + predicted * predictor.slack[i]) *
                             (at_.inequality[i] + predicted * predictor.inequality[i]);
        }
        predicted_gap /= static_cast<double>(complementarity.size());
        const double aim = gap() * std::pow(predicted_gap / gap(), 3.0);
        for (std::size_t i = 0; i < complementarity.size(); ++i) {
            complementarity[i] += predictor.slack[i] * predictor.inequality[i] - aim;
        }
        const Point step = newton_step(factors, residual, complementarity);

        const double length = std::min(1.0, 0.995 * longest(step));
        const auto move = [length](Vector& v, const Vector& by) {
            for (std::size_t i = 0; i < v.size(); ++i) v[i] += length * by[i];
        };
        move(at_.x, step.x);
        move(at_.equality, step.equality);
        move(at_.slack, step.slack);
        move(at_.inequality, step.inequality);
        return length > 1e-10;
    }

    const QuadraticProgram& program_;
    Point at_;
};

}  // namespace

std::optional<std::vector<double>> minimise(const QuadraticProgram& program, const std::vector<double>& start) {
    return InteriorPoint(program, start).minimise();
}

}  // namespace emulsion
