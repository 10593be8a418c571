#include "spectrum/sigmoid_solver.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "core/matrix3.h"
#include "core/units.h"
#include "spectrum/lab_function.h"
#include "spectrum/sigmoid.h"

namespace emulsion {

namespace {

using Vector3 = std::array<double, 3>;

// The solver's coefficients are the centred ones of sigmoid.h.

// Bound on them, well beyond what any colour within reach needs: where none is, they would grow for ever.
constexpr double kLargestCoefficient = 1e6;

// Luminance of the darkest constant to start from; 1 less this is the lightest.
constexpr double kDarkestStart = 1e-9;

// What is to be made small, as a quadratic model around some coefficients.
struct Linearisation {
    Matrix3 hessian;     // half of it, in Gauss's and Newton's approximation
    Vector3 gradient{};  // half of it
    double squared_difference = 0.0, cost = 0.0;
};

// White-relative XYZ to CIELAB, without the constant that every L* has.
Vector3 lab_of(const Vector3& xyz) noexcept {
    const double fx = lab_f(xyz[0]), fy = lab_f(xyz[1]), fz = lab_f(xyz[2]);
    return {116.0 * fy, 500.0 * (fx - fy), 200.0 * (fy - fz)};
}

Linearisation linearise(const ReflectanceWeights& weights, const Vector3& k, const Vector3& target,
                        double penalty) noexcept {
    // Sums of reflectance, and of its derivatives by the three coefficients.
    Vector3 xyz{};
    Matrix3 xyz_by_k;
    for (std::size_t i = 0; i < kWholeNanometres; ++i) {
        const double s = (kMinWavelength_nm + static_cast<double>(i) - kSigmoidCentre_nm) / kSigmoidWidth_nm;
        const double x = (k[0] * s + k[1]) * s + k[2];
        const double reflectance = sigmoid(x);
        const double slope = 0.5 / ((1.0 + x * x) * std::sqrt(1.0 + x * x));
        for (std::size_t j = 0; j < 3; ++j) {
            const double weight = weights.sum[j][i], weighted_slope = weight * slope;
            xyz[j] += weight * reflectance;
            xyz_by_k.m[j][0] += weighted_slope * s * s;
            xyz_by_k.m[j][1] += weighted_slope * s;
            xyz_by_k.m[j][2] += weighted_slope;
        }
    }

    // From there to CIELAB by the chain rule.
    const Vector3 lab = lab_of(xyz);
    const double fx = lab_f_derivative(xyz[0]), fy = lab_f_derivative(xyz[1]), fz = lab_f_derivative(xyz[2]);
    const Matrix3 lab_by_xyz{
        {{{0.0, 116.0 * fy, 0.0}, {500.0 * fx, -500.0 * fy, 0.0}, {0.0, 200.0 * fy, -200.0 * fz}}}};
    const Matrix3 jacobian = lab_by_xyz * xyz_by_k;
    const Vector3 residual = {lab[0] - target[0], lab[1] - target[1], lab[2] - target[2]};

    Linearisation result;
    for (std::size_t i = 0; i < 3; ++i) {
        result.hessian.m[i][i] = penalty;
        result.gradient[i] = penalty * k[i];
        for (std::size_t row = 0; row < 3; ++row) {
            result.gradient[i] += jacobian.m[row][i] * residual[row];
            for (std::size_t j = 0; j < 3; ++j) result.hessian.m[i][j] += jacobian.m[row][i] * jacobian.m[row][j];
        }
        result.squared_difference += residual[i] * residual[i];
        result.cost += penalty * k[i] * k[i];
    }
    result.cost += result.squared_difference;
    return result;
}

// The step of Levenberg-Marquardt: (H + damping diag H) step = -gradient, by Cholesky's method on the matrix scaled to
// unit diagonal. Unset where H vanishes or rounding makes the matrix singular.
std::optional<Vector3> damped_step(const Linearisation& at, double damping) noexcept {
    const auto& hessian = at.hessian.m;
    Vector3 scale{}, y{};
    for (std::size_t i = 0; i < 3; ++i) scale[i] = 1.0 / std::sqrt(hessian[i][i]);
    std::array<std::array<double, 3>, 3> lower{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            double element = i == j ? 1.0 + damping : hessian[i][j] * scale[i] * scale[j];
            for (std::size_t k = 0; k < j; ++k) element -= lower[i][k] * lower[j][k];
            if (i == j && !(element > 1e-15)) return std::nullopt;
            lower[i][j] = i == j ? std::sqrt(element) : element / lower[j][j];
        }
        y[i] = -at.gradient[i] * scale[i];
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

// Improves the centred coefficients k until an end of the search is reached or nothing helps; its start is not used.
void improve(const ReflectanceWeights& weights, const Vector3& target, const SigmoidSearch& search,
             Vector3& k) noexcept {
    const double accepted = search.accepted_difference * search.accepted_difference;
    double damping = 1e-3;
    Linearisation at = linearise(weights, k, target, search.penalty);
    for (int i = 1; i < search.evaluations && at.squared_difference > accepted && damping < 1e12; ++i) {
        const std::optional<Vector3> step = damped_step(at, damping);
        if (!step) {
            damping *= 10.0;
            continue;
        }
        const Vector3 trial = {k[0] + (*step)[0], k[1] + (*step)[1], k[2] + (*step)[2]};
        const Linearisation there = linearise(weights, trial, target, search.penalty);
        if (within_bound(trial) && there.cost < at.cost) {
            const bool little = at.cost - there.cost < search.least_gain * at.cost;
            k = trial;
            at = there;
            damping *= 0.1;
            if (little) return;
        } else {
            damping *= 10.0;
        }
    }
}

}  // namespace

SigmoidSpectrum solve_sigmoid(const ReflectanceWeights& weights, const XYZd& target) noexcept {
    // From the constant of the same luminance, which has coefficients of the right size also for dark colours, by way
    // of the colour of half the saturation: that one is easy, and from there it isn't far.
    const double grey = std::clamp(target.y, kDarkestStart, 1.0 - kDarkestStart);
    const Vector3 half_way = {0.5 * (grey + target.x), 0.5 * (grey + target.y), 0.5 * (grey + target.z)};
    Vector3 k = {0.0, 0.0, inverse_sigmoid(grey)};
    improve(weights, lab_of(half_way), {.start = {}, .accepted_difference = 0.1, .evaluations = 20}, k);
    improve(weights, lab_of({target.x, target.y, target.z}), {}, k);
    return {sigmoid_from_centred(k)};
}

SigmoidSpectrum improved_sigmoid(const ReflectanceWeights& weights, const XYZd& target,
                                 const SigmoidSearch& search) noexcept {
    Vector3 k = centred_from_sigmoid(search.start.c);
    improve(weights, lab_of({target.x, target.y, target.z}), search, k);
    return {sigmoid_from_centred(k)};
}

}  // namespace emulsion
