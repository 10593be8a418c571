#include "spectrum/sigmoid_solver.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "core/matrix3.h"
#include "core/units.h"
#include "spectrum/cielab.h"
#include "spectrum/observer.h"
#include "spectrum/sigmoid.h"

namespace emulsion {

namespace {

using Vector3 = std::array<double, 3>;

// The solver's polynomial is a s^2 + b s + c in s = (lambda - 550 nm)/100 nm: about where the eye sees, which makes the
// three coefficients matter alike.
constexpr double kCentre_nm = 550.0;
constexpr double kWidth_nm = 100.0;

// Bound on them, well beyond what any colour within reach needs: where none is, they would grow for ever.
constexpr double kLargestCoefficient = 1e6;

// Luminance of the darkest constant to start from; 1 less this is the lightest.
constexpr double kDarkestStart = 1e-9;

SigmoidSpectrum sigmoid_from(const Vector3& k) noexcept {
    // s = scale * t + offset with the t of SigmoidSpectrum.
    constexpr double kScale = (kMaxWavelength_nm - kMinWavelength_nm) / kWidth_nm;
    constexpr double kOffset = (kMinWavelength_nm - kCentre_nm) / kWidth_nm;
    return {{k[0] * kScale * kScale, (2.0 * k[0] * kOffset + k[1]) * kScale, (k[0] * kOffset + k[1]) * kOffset + k[2]}};
}

// Residual in CIELAB and its derivatives by the coefficients.
struct Linearisation {
    Vector3 residual{};
    Matrix3 jacobian;
    double cost = 0.0;  // squared CIELAB difference
};

// Derivative of CIELAB's f: of the cube root, or of its linear toe.
double lab_f_derivative(double ratio) noexcept {
    constexpr double kKnee = 6.0 / 29.0;
    if (ratio > kKnee * kKnee * kKnee) return 1.0 / (3.0 * std::cbrt(ratio) * std::cbrt(ratio));
    return 1.0 / (3.0 * kKnee * kKnee);
}

Linearisation linearise(const ReflectanceWeights& weights, const Vector3& k, const Lab& target) noexcept {
    // Sums of reflectance, and of its derivatives by the three coefficients.
    Vector3 xyz{};
    Matrix3 xyz_by_k;
    for (std::size_t i = 0; i < weights.xyz[0].size(); ++i) {
        const double s = (kMinWavelength_nm + static_cast<double>(i) - kCentre_nm) / kWidth_nm;
        const double x = (k[0] * s + k[1]) * s + k[2];
        const double reflectance = sigmoid(x);
        const double slope = 0.5 / ((1.0 + x * x) * std::sqrt(1.0 + x * x));
        for (std::size_t j = 0; j < 3; ++j) {
            const double weight = weights.xyz[j][i], weighted_slope = weight * slope;
            xyz[j] += weight * reflectance;
            xyz_by_k.m[j][0] += weighted_slope * s * s;
            xyz_by_k.m[j][1] += weighted_slope * s;
            xyz_by_k.m[j][2] += weighted_slope;
        }
    }

    // From there to CIELAB by the chain rule.
    const Lab lab = lab_from_xyz({xyz[0], xyz[1], xyz[2]}, {1.0, 1.0, 1.0});
    const double fx = lab_f_derivative(xyz[0]), fy = lab_f_derivative(xyz[1]), fz = lab_f_derivative(xyz[2]);
    const Matrix3 lab_by_xyz{
        {{{0.0, 116.0 * fy, 0.0}, {500.0 * fx, -500.0 * fy, 0.0}, {0.0, 200.0 * fy, -200.0 * fz}}}};
    Linearisation result;
    result.residual = {lab.l - target.l, lab.a - target.a, lab.b - target.b};
    result.jacobian = lab_by_xyz * xyz_by_k;
    for (const double r : result.residual) result.cost += r * r;
    return result;
}

// The step of Levenberg-Marquardt: (J'J + damping diag J'J) step = -J'r, by Cholesky's method on the matrix scaled to
// unit diagonal. Unset where J'J vanishes or rounding makes the matrix singular.
std::optional<Vector3> damped_step(const Linearisation& at, double damping) noexcept {
    const auto& jacobian = at.jacobian.m;
    Vector3 scale{}, gradient{};
    for (std::size_t i = 0; i < 3; ++i) {
        double diagonal = 0.0;
        for (std::size_t row = 0; row < 3; ++row) {
            diagonal += jacobian[row][i] * jacobian[row][i];
            gradient[i] += jacobian[row][i] * at.residual[row];
        }
        scale[i] = 1.0 / std::sqrt(diagonal);
    }

    std::array<std::array<double, 3>, 3> lower{};
    Vector3 y{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            double element = i == j ? 1.0 + damping : 0.0;
            if (i != j) {
                for (std::size_t row = 0; row < 3; ++row) element += jacobian[row][i] * jacobian[row][j];
                element *= scale[i] * scale[j];
            }
            for (std::size_t k = 0; k < j; ++k) element -= lower[i][k] * lower[j][k];
            if (i == j && !(element > 1e-15)) return std::nullopt;
            lower[i][j] = i == j ? std::sqrt(element) : element / lower[j][j];
        }
        y[i] = -gradient[i] * scale[i];
        for (std::size_t k = 0; k < i; ++k) y[i] -= lower[i][k] * y[k];
        y[i] /= lower[i][i];
    }
    for (std::size_t i = 3; i-- > 0;) {
        for (std::size_t k = i + 1; k < 3; ++k) y[i] -= lower[k][i] * y[k];
        y[i] /= lower[i][i];
    }
    return Vector3{y[0] * scale[0], y[1] * scale[1], y[2] * scale[2]};
}

bool within_bound(const Vector3& k) noexcept {
    return std::all_of(k.begin(), k.end(), [](double component) { return std::abs(component) <= kLargestCoefficient; });
}

struct Limits {
    double cost = 0.0;
    int evaluations = 0;
};

// Improves k until the squared CIELAB difference is at most limits.cost, nothing helps, or the budget is used up.
void improve(const ReflectanceWeights& weights, const Lab& target, const Limits& limits, Vector3& k) noexcept {
    double damping = 1e-3;
    Linearisation at = linearise(weights, k, target);
    for (int i = 1; i < limits.evaluations && at.cost > limits.cost && damping < 1e12; ++i) {
        const std::optional<Vector3> step = damped_step(at, damping);
        if (!step) {
            damping *= 10.0;
            continue;
        }
        const Vector3 trial = {k[0] + (*step)[0], k[1] + (*step)[1], k[2] + (*step)[2]};
        const Linearisation there = linearise(weights, trial, target);
        if (within_bound(trial) && there.cost < at.cost) {
            k = trial;
            at = there;
            damping *= 0.1;
        } else {
            damping *= 10.0;
        }
    }
}

}  // namespace

ReflectanceWeights reflectance_weights(const Spectrum& illuminant) {
    const Observer& observer = cie_1931_2deg();
    const std::array<double XYZd::*, 3> functions = {&XYZd::x, &XYZd::y, &XYZd::z};
    ReflectanceWeights weights;
    for (std::size_t i = 0; i < 3; ++i) {
        std::vector<double>& weight = weights.xyz[i];
        weight.assign(kMaxWavelength_nm - kMinWavelength_nm + 1, 0.0);
        const auto product = [&](double lambda_nm) {
            return eval(illuminant, lambda_nm) * eval(observer, lambda_nm).*functions[i];
        };
        // Each cell's integral of product times falling and rising line, by Simpson's rule: exact for straight lines.
        for (std::size_t cell = 0; cell + 1 < weight.size(); ++cell) {
            const double start_nm = kMinWavelength_nm + static_cast<double>(cell);
            const double middle = product(start_nm + 0.5);
            weight[cell] += (product(start_nm) + 2.0 * middle) / 6.0;
            weight[cell + 1] += (2.0 * middle + product(start_nm + 1.0)) / 6.0;
        }
        const double sum = std::accumulate(weight.begin(), weight.end(), 0.0);
        if (!(sum > 0.0)) throw std::invalid_argument("illuminant: 0 in the visible, expected light");
        for (double& w : weight) w /= sum;
    }
    return weights;
}

XYZd relative_xyz(const ReflectanceWeights& weights, const Spectrum& reflectance) noexcept {
    XYZd sum;
    for (std::size_t i = 0; i < weights.xyz[0].size(); ++i) {
        const double value = eval(reflectance, kMinWavelength_nm + static_cast<double>(i));
        sum = sum + value * XYZd{weights.xyz[0][i], weights.xyz[1][i], weights.xyz[2][i]};
    }
    return sum;
}

SigmoidSpectrum solve_sigmoid(const ReflectanceWeights& weights, const XYZd& target) noexcept {
    // From the constant of the same luminance, which has coefficients of the right size also for dark colours, by way
    // of the colour of half the saturation: that one is easy, and from there it isn't far.
    const XYZd white = {1.0, 1.0, 1.0};
    const double grey = std::clamp(target.y, kDarkestStart, 1.0 - kDarkestStart);
    const XYZd half_way = 0.5 * (grey * white + target);
    Vector3 k = {0.0, 0.0, inverse_sigmoid(grey)};
    improve(weights, lab_from_xyz(half_way, white), {.cost = 1e-2, .evaluations = 20}, k);
    improve(weights, lab_from_xyz(target, white), {.cost = 1e-18, .evaluations = 100}, k);
    return sigmoid_from(k);
}

}  // namespace emulsion
