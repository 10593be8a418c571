#include "spectrum/uplift_basis.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>

#include "spectrum/convex_qp.h"

namespace emulsion {

namespace {

constexpr std::size_t kKnots = (kMaxWavelength_nm - kMinWavelength_nm) / PrimaryBasis::kStep_nm + 1;
static_assert((kMaxWavelength_nm - kMinWavelength_nm) % PrimaryBasis::kStep_nm == 0);

// Weights of the values at knots, with straight lines between.
std::vector<double> weights_of_knots(const std::vector<double>& whole_nm_weights) {
    std::vector<double> weights(kKnots);
    for (std::size_t i = 0; i < kWholeNanometres; ++i) {
        const std::size_t knot = i / PrimaryBasis::kStep_nm;
        const double fraction = static_cast<double>(i % PrimaryBasis::kStep_nm) / PrimaryBasis::kStep_nm;
        weights[knot] += (1.0 - fraction) * whole_nm_weights[i];
        if (fraction > 0.0) weights[knot + 1] += fraction * whole_nm_weights[i];
    }
    return weights;
}

// The unknowns are red and green at the knots, in turn; blue is what they lack to 1.
std::size_t red(std::size_t knot) noexcept { return 2 * knot; }
std::size_t green(std::size_t knot) noexcept { return 2 * knot + 1; }

QuadraticProgram smoothest_basis(const ReflectanceWeights& rgb_weights) {
    QuadraticProgram program;
    program.hessian.assign(2 * kKnots, std::vector<double>(2 * kKnots));
    program.gradient.assign(2 * kKnots, 0.0);

    // With steps dr and dg from knot to knot, blue's is -dr - dg: the squares' sum is 2 (dr^2 + dr dg + dg^2).
    const auto add_product = [&](std::size_t a, std::size_t b, double factor) {
        // factor * (step of a) * (step of b)
        program.hessian[a][b] += factor;
        program.hessian[a + 2][b + 2] += factor;
        program.hessian[a + 2][b] -= factor;
        program.hessian[a][b + 2] -= factor;
    };
    for (std::size_t i = 0; i + 1 < kKnots; ++i) {
        add_product(red(i), red(i), 2.0);
        add_product(green(i), green(i), 2.0);
        add_product(red(i), green(i), 1.0);
        add_product(green(i), red(i), 1.0);
    }

    // Red is (1, 0, 0) and green (0, 1, 0); blue follows, as white is (1, 1, 1).
    for (std::size_t row = 0; row < 3; ++row) {
        const std::vector<double> weights = weights_of_knots(rgb_weights.sum[row]);
        std::vector<double> of_red(2 * kKnots), of_green(2 * kKnots);
        for (std::size_t i = 0; i < kKnots; ++i) of_red[red(i)] = of_green[green(i)] = weights[i];
        program.equalities.push_back(std::move(of_red));
        program.equality_values.push_back(row == 0 ? 1.0 : 0.0);
        program.equalities.push_back(std::move(of_green));
        program.equality_values.push_back(row == 1 ? 1.0 : 0.0);
    }

    for (std::size_t i = 0; i < kKnots; ++i) {
        program.inequalities.push_back({{{red(i), 1.0}}, 0.0});
        program.inequalities.push_back({{{green(i), 1.0}}, 0.0});
        program.inequalities.push_back({{{red(i), -1.0}, {green(i), -1.0}}, -1.0});
    }
    return program;
}

}  // namespace

PrimaryBasis::PrimaryBasis(const ReflectanceRgb& space) {
    const auto solution = minimise(smoothest_basis(space.rgb_weights), std::vector<double>(2 * kKnots, 1.0 / 3.0));
    if (!solution) {
        throw std::invalid_argument(
            "mallett-yuksel: RGB space: expected one whose primaries are reflectances that add up to 1, as those of "
            "sRGB do");
    }
    for (std::size_t i = 0; i < kKnots; ++i) {
        const double r = std::clamp((*solution)[red(i)], 0.0, 1.0);
        const double g = std::clamp((*solution)[green(i)], 0.0, 1.0 - r);
        lambda_nm_.push_back(kMinWavelength_nm + static_cast<double>(i) * kStep_nm);
        primary_[0].push_back(r);
        primary_[1].push_back(g);
        primary_[2].push_back(std::max(0.0, 1.0 - r - g));
    }
}

PiecewiseLinearSpectrum PrimaryBasis::reflectance(const RGBd& rgb) const {
    PiecewiseLinearSpectrum spectrum{lambda_nm_, {}, Extrapolation::hold};
    spectrum.value.reserve(kKnots);
    for (std::size_t i = 0; i < kKnots; ++i) {
        const double sum = rgb.r * primary_[0][i] + rgb.g * primary_[1][i] + rgb.b * primary_[2][i];
        spectrum.value.push_back(std::min(sum, 1.0));  // against rounding
    }
    return spectrum;
}

}  // namespace emulsion
