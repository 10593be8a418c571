#include "spectrum/uplift_smits.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <vector>

#include "spectrum/convex_qp.h"

namespace emulsion {

namespace {

constexpr std::size_t kBins = SmitsBasis::kBins;

// Which bin a whole nanometre lies in; an edge belongs to the bin below.
std::size_t bin_of(int lambda_nm) noexcept {
    const int bin = (lambda_nm - 1 - SmitsBasis::kFirst_nm) / SmitsBasis::kBinWidth_nm;
    return static_cast<std::size_t>(std::clamp(bin, 0, SmitsBasis::kBins - 1));
}

// Linear RGB of the bins.
DenseMatrix rgb_from_bins(const ReflectanceWeights& rgb_weights) {
    DenseMatrix matrix(3, std::vector<double>(kBins));
    for (std::size_t i = 0; i < kWholeNanometres; ++i) {
        const std::size_t bin = bin_of(kMinWavelength_nm + static_cast<int>(i));
        for (std::size_t j = 0; j < 3; ++j) matrix[j][bin] += rgb_weights.sum[j][i];
    }
    return matrix;
}

// The smoothest bins in [0, 1]: least sum of squared steps.
QuadraticProgram smoothest_bins() {
    QuadraticProgram program;
    program.hessian.assign(kBins, std::vector<double>(kBins));
    program.gradient.assign(kBins, 0.0);
    for (std::size_t i = 0; i + 1 < kBins; ++i) {
        program.hessian[i][i] += 1.0;
        program.hessian[i + 1][i + 1] += 1.0;
        program.hessian[i][i + 1] = program.hessian[i + 1][i] = -1.0;
    }
    for (std::size_t i = 0; i < kBins; ++i) {
        program.inequalities.push_back({{{i, 1.0}}, 0.0});
        program.inequalities.push_back({{{i, -1.0}}, -1.0});
    }
    return program;
}

// Of the colour if there is one, else of the colour nearest to it: squared difference in linear RGB.
std::vector<double> solve_bins(const DenseMatrix& matrix, const std::vector<double>& rgb) {
    const std::vector<double> start(kBins, 0.5);
    QuadraticProgram exact = smoothest_bins();
    exact.equalities = matrix;
    exact.equality_values = rgb;
    if (const auto bins = minimise(exact, start)) return *bins;

    // The squared difference weighs a million times as much as smoothness.
    constexpr double kSmoothness = 1e-6;
    QuadraticProgram nearest = smoothest_bins();
    for (std::size_t i = 0; i < kBins; ++i) {
        for (std::size_t j = 0; j < kBins; ++j) {
            nearest.hessian[i][j] *= kSmoothness;
            for (std::size_t row = 0; row < 3; ++row) nearest.hessian[i][j] += matrix[row][i] * matrix[row][j];
        }
        for (std::size_t row = 0; row < 3; ++row) nearest.gradient[i] -= matrix[row][i] * rgb[row];
    }
    const auto bins = minimise(nearest, start);
    if (!bins) throw std::logic_error("Smits's basis: bins in [0, 1] always exist, and were not found");
    return *bins;
}

}  // namespace

SmitsBasis::SmitsBasis(const ReflectanceRgb& space) {
    const DenseMatrix matrix = rgb_from_bins(space.rgb_weights);
    for (std::size_t i = 0; i < 3; ++i) {
        std::vector<double> primary(3, 0.0), secondary(3, 1.0);
        primary[i] = 1.0;
        secondary[i] = 0.0;
        const auto store = [](const std::vector<double>& bins, Bins& result) {
            std::transform(bins.begin(), bins.end(), result.begin(), [](double v) { return std::clamp(v, 0.0, 1.0); });
        };
        store(solve_bins(matrix, primary), primary_[i]);
        store(solve_bins(matrix, secondary), secondary_[i]);
    }
}

PiecewiseLinearSpectrum SmitsBasis::reflectance(const RGBd& rgb) const {
    // The white part is the least component, the secondary lacks it, the primary is the largest.
    const std::array<double, 3> c = {rgb.r, rgb.g, rgb.b};
    const auto least = static_cast<std::size_t>(std::min_element(c.begin(), c.end()) - c.begin());
    const auto most = least == 0   ? (c[1] >= c[2] ? 1U : 2U)
                      : least == 1 ? (c[0] >= c[2] ? 0U : 2U)
                                   : (c[0] >= c[1] ? 0U : 1U);
    const double white = c[least], middle = c[3 - least - most];
    Bins bins{};
    for (std::size_t i = 0; i < kBins; ++i) {
        const double sum = white + (middle - white) * secondary_[least][i] + (c[most] - middle) * primary_[most][i];
        bins[i] = std::min(sum, 1.0);  // against rounding
    }

    PiecewiseLinearSpectrum spectrum{{kMinWavelength_nm}, {bins.front()}, Extrapolation::hold};
    for (std::size_t i = 0; i + 1 < kBins; ++i) {
        const double edge_nm = kFirst_nm + (static_cast<int>(i) + 1) * kBinWidth_nm;
        spectrum.lambda_nm.insert(spectrum.lambda_nm.end(), {edge_nm, edge_nm + 1.0});
        spectrum.value.insert(spectrum.value.end(), {bins[i], bins[i + 1]});
    }
    spectrum.lambda_nm.push_back(kMaxWavelength_nm);
    spectrum.value.push_back(bins.back());
    return spectrum;
}

}  // namespace emulsion
