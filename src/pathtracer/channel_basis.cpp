#include "pathtracer/channel_basis.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "core/units.h"
#include "pathtracer/spectrum_nodes.h"
#include "spectrum/colorimetry.h"
#include "spectrum/observer.h"

namespace emulsion {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Spectra by their values at whole nanometres.
constexpr int kNodes = kMaxWavelength_nm - kMinWavelength_nm + 1;

/// The most products of lights and reflectances that are looked at.
constexpr std::size_t kMostProducts = 1024;

VectorXd nodes_of(const Spectrum& spectrum) {
    const std::vector<double> integrals = node_integrals(spectrum);
    return Eigen::Map<const VectorXd>(integrals.data(), kNodes);
}

/// Of a reflectance: its values.
VectorXd values_at_nodes(const Spectrum& spectrum) {
    VectorXd values(kNodes);
    for (int i = 0; i < kNodes; ++i) values[i] = eval(spectrum, static_cast<double>(kMinWavelength_nm + i));
    return values;
}

/// Columns: xbar, ybar, zbar.
MatrixXd observer_nodes() {
    MatrixXd functions(kNodes, 3);
    for (int i = 0; i < kNodes; ++i) {
        const XYZd xyz = eval(cie_1931_2deg(), static_cast<double>(kMinWavelength_nm + i));
        functions.row(i) << xyz.x, xyz.y, xyz.z;
    }
    return functions;
}

/// Light that may leave a surface of the scene: columns, each of about the same importance to the eye.
MatrixXd occurring_light(const SceneSpectra& spectra, const std::vector<VectorXd>& reflectances,
                         const VectorXd& luminous) {
    double total_flux = 0.0;
    for (const auto& light : spectra.lights) total_flux += light.flux;
    const std::size_t n = reflectances.size(), per_light = 1 + n + n * (n + 1) / 2;
    const std::size_t stride = 1 + per_light * spectra.lights.size() / kMostProducts;

    std::vector<VectorXd> columns;
    for (const auto& light : spectra.lights) {
        VectorXd power = nodes_of(light.spectrum);
        power /= std::max(power.dot(luminous), 1e-300);
        const double share = std::sqrt(light.flux / total_flux);
        std::size_t count = 0;
        const auto add = [&](const VectorXd& seen) {
            // Between the absolute and the relative difference, as lightness is.
            const double luminance = seen.dot(luminous);
            if (luminance > 0.0 && count++ % stride == 0) columns.push_back(share / std::sqrt(luminance) * seen);
        };
        add(power);
        for (const VectorXd& r : reflectances) add(power.cwiseProduct(r));
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j <= i; ++j) add(power.cwiseProduct(reflectances[i]).cwiseProduct(reflectances[j]));
        }
    }
    MatrixXd light(kNodes, static_cast<Eigen::Index>(columns.size()));
    for (std::size_t i = 0; i < columns.size(); ++i) light.col(static_cast<Eigen::Index>(i)) = columns[i];
    return light;
}

/// Orthonormal columns that span the first three of `functions` columns exactly, and most of `light` beyond them.
MatrixXd main_components(const MatrixXd& exact, const MatrixXd& light, int functions) {
    MatrixXd basis(kNodes, functions);
    basis.leftCols(3) = Eigen::HouseholderQR<MatrixXd>(exact).householderQ() * MatrixXd::Identity(kNodes, 3);
    if (functions == 3) return basis;
    const MatrixXd known = basis.leftCols(3);
    const MatrixXd rest = light - known * (known.transpose() * light);
    // Eigenvalues rise. What they leave open, for scenes of few spectra, is orthogonal all the same; it must be so to
    // the observer's functions, too.
    const MatrixXd covariance = rest * rest.transpose();
    const double away = 1.0 + covariance.trace();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(covariance - away * known * known.transpose());
    basis.rightCols(functions - 3) = eigen.eigenvectors().rightCols(functions - 3);
    return basis;
}

/// Turns the columns of `basis` within their space until the products of its functions with the columns of `factors`
/// mix them least.
void diagonalise_products(MatrixXd& basis, const MatrixXd& factors) {
    const Eigen::Index k = basis.cols();
    std::vector<MatrixXd> products;
    for (Eigen::Index j = 0; j < factors.cols(); ++j) {
        products.emplace_back(basis.transpose() * factors.col(j).asDiagonal() * basis);
    }
    constexpr int kSweeps = 60;
    constexpr double kStill = 1e-10;  // radians
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        double largest = 0.0;
        for (Eigen::Index p = 0; p + 1 < k; ++p) {
            for (Eigen::Index q = p + 1; q < k; ++q) {
                double on = 0.0, off = 0.0;
                for (const MatrixXd& a : products) {
                    const double difference = a(p, p) - a(q, q), mixed = 2.0 * a(p, q);
                    on += difference * difference - mixed * mixed;
                    off += 2.0 * difference * mixed;
                }
                const double angle = 0.5 * std::atan2(off, on + std::hypot(on, off));
                if (!(std::abs(angle) > kStill)) continue;
                largest = std::max(largest, std::abs(angle));
                const Eigen::JacobiRotation<double> rotation(std::cos(angle), std::sin(angle));
                basis.applyOnTheRight(p, q, rotation.transpose());
                for (MatrixXd& a : products) {
                    a.applyOnTheRight(p, q, rotation.transpose());
                    a.applyOnTheLeft(p, q, rotation);
                }
            }
        }
        if (largest == 0.0) return;
    }
}

/// The factors that light meets in the scene, and the wavelength itself with a small weight: where all else is grey it
/// alone decides, and makes the functions as narrow as their space allows.
MatrixXd factors_of(const std::vector<VectorXd>& reflectances) {
    MatrixXd factors(kNodes, static_cast<Eigen::Index>(reflectances.size()) + 1);
    constexpr double kWavelengthWeight = 0.1;
    factors.col(0) = VectorXd::LinSpaced(kNodes, 0.0, kWavelengthWeight);
    for (std::size_t j = 0; j < reflectances.size(); ++j) {
        factors.col(static_cast<Eigen::Index>(j) + 1) = reflectances[j];
    }
    return factors;
}

std::vector<double> values_of(const VectorXd& nodes) { return {nodes.begin(), nodes.end()}; }

/// What makes one reflection of `light` right, by the least change of the reflectances: `means` are columns whose
/// product with a reflectance is its r_k, `xyz` has a row for each channel. Their sums, r_k of white, stay 1.
void correct_for_one_reflection(MatrixXd& means, const MatrixXd& h, const MatrixXd& xyz, const MatrixXd& observer,
                                const Spectrum& light) {
    // X, Y and Z of the light of each channel.
    const MatrixXd seen = (h.transpose() * nodes_of(light)).asDiagonal() * xyz;
    MatrixXd exact(kNodes, 3);
    for (Eigen::Index m = 0; m < 3; ++m) {
        const Spectrum curve = DenseSpectrum{static_cast<double>(kMinWavelength_nm), 1.0, values_of(observer.col(m))};
        exact.col(m) = kLuminousEfficacy * nodes_of(product_of(light, curve));
    }
    const MatrixXd missing = exact - means * seen;
    // Of a light that is all but monochromatic, not all three can be told apart.
    constexpr double kTooSmall = 1e-3;
    Eigen::JacobiSVD<MatrixXd> svd(seen.transpose(), Eigen::ComputeThinU | Eigen::ComputeThinV);
    svd.setThreshold(kTooSmall);
    means += svd.solve(missing.transpose()).transpose();
}

}  // namespace

Spectrum sum_of_lights(const SceneSpectra& spectra) {
    if (spectra.lights.empty()) return ConstantSpectrum{1.0};
    SumSpectrum sum;
    for (const auto& light : spectra.lights) {
        const double luminous = photometric_integral(light.spectrum);
        if (!(luminous > 0.0)) continue;
        sum.term.push_back(light.spectrum);
        sum.weight.push_back(light.flux / luminous);
    }
    return sum;
}

FixedChannels basis_channels(const SceneSpectra& spectra, int functions) {
    SceneSpectra scene = spectra;
    if (scene.lights.empty()) scene.lights.push_back({ConstantSpectrum{1.0}, 1.0});
    std::vector<VectorXd> reflectances;
    for (const Spectrum& spectrum : scene.reflectances) reflectances.push_back(values_at_nodes(spectrum));

    // Functions f are kept as f sqrt(w), and so are orthonormal in the eye's measure w.
    const MatrixXd observer = observer_nodes();
    const VectorXd eye = observer.rowwise().sum();
    const VectorXd root = eye.cwiseSqrt();
    const MatrixXd exact = root.cwiseInverse().asDiagonal() * observer;
    const MatrixXd light = root.asDiagonal() * occurring_light(scene, reflectances, observer.col(1));
    MatrixXd basis = main_components(exact, light, functions);
    diagonalise_products(basis, factors_of(reflectances));

    // Of unit sign: light is positive in each channel.
    MatrixXd xyz = basis.transpose() * exact;
    for (Eigen::Index k = 0; k < basis.cols(); ++k) {
        if (xyz.row(k).sum() >= 0.0) continue;
        xyz.row(k) *= -1.0;
        basis.col(k) *= -1.0;
    }
    const MatrixXd h = kLuminousEfficacy * root.asDiagonal() * basis;
    MatrixXd means = basis.cwiseAbs2();
    correct_for_one_reflection(means, h, xyz, observer, sum_of_lights(scene));

    FixedChannels channels;
    for (Eigen::Index k = 0; k < basis.cols(); ++k) {
        channels.push_back(
            {values_of(h.col(k)), normalised_weights(values_of(means.col(k))), {xyz(k, 0), xyz(k, 1), xyz(k, 2)}});
    }
    return channels;
}

}  // namespace emulsion
