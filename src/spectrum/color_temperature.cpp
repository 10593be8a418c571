#include "spectrum/color_temperature.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include <fmt/core.h>

#include "core/units.h"

namespace emulsion {

namespace {

constexpr double kSecondRadiation_nmK = 1e9 * kSecondRadiation_mK;

// Gauss's three points on [0, 1]: exact for polynomials of degree 5. Over a nanometre of Planck's law times a straight
// line they are right to 1e-13 even at 500 K.
struct GaussPoint {
    double position, weight;
};
constexpr std::array<GaussPoint, 3> kGauss = {
    {{0.1127016653792583, 5.0 / 18.0}, {0.5, 8.0 / 18.0}, {0.8872983346207417, 5.0 / 18.0}}};

double dot(const Uv1960& a, const Uv1960& b) noexcept { return a.u * b.u + a.v * b.v; }
Uv1960 minus(const Uv1960& a, const Uv1960& b) noexcept { return {a.u - b.u, a.v - b.v}; }

void require_temperature(double temperature_K) {
    if (temperature_K >= PlanckianLocus::kColdest_K && temperature_K <= PlanckianLocus::kHottest_K) return;
    throw std::invalid_argument(fmt::format("temperature_K = {}: expected a number in [{}, {}]", temperature_K,
                                            PlanckianLocus::kColdest_K, PlanckianLocus::kHottest_K));
}

}  // namespace

PlanckianLocus::PlanckianLocus(const Observer& observer) {
    for (std::size_t i = 0; i + 1 < observer.value.size(); ++i) {
        for (const GaussPoint& gauss : kGauss) {
            const double lambda_nm = observer.first_nm + static_cast<double>(i) + gauss.position;
            const XYZd xyz = (1.0 - gauss.position) * observer.value[i] + gauss.position * observer.value[i + 1];
            const double scale = gauss.weight * std::pow(lambda_nm / 560.0, -5.0);
            abscissae_.push_back(
                {kSecondRadiation_nmK / (1e6 * lambda_nm),
                 {scale * 4.0 * xyz.x, scale * 6.0 * xyz.y, scale * (xyz.x + 15.0 * xyz.y + 3.0 * xyz.z)}});
        }
    }

    // Two per cent apart, and one beyond each end, so that the ends themselves are found like all others.
    constexpr double kRatio = 1.02;
    constexpr double kFirst = 1e6 / kHottest_K / kRatio, kLast = 1e6 / kColdest_K * kRatio;
    double mired = kFirst;
    while (mired < kLast * kRatio) {
        node_mired_.push_back(mired);
        node_uv_.push_back(at(mired).uv);
        mired *= kRatio;
    }
}

PlanckianLocus::Point PlanckianLocus::at(double mired) const noexcept {
    // B = 1 / (exp(x) - 1) with x = exponent * mired, and its derivatives by the mired.
    std::array<double, 3> sum{}, first{}, second{};
    for (const Abscissa& abscissa : abscissae_) {
        const double b = 1.0 / std::expm1(abscissa.exponent * mired);
        const double b1 = -abscissa.exponent * b * (1.0 + b);
        const double b2 = -abscissa.exponent * b1 * (1.0 + 2.0 * b);
        for (std::size_t j = 0; j < 3; ++j) {
            sum[j] += abscissa.weight[j] * b;
            first[j] += abscissa.weight[j] * b1;
            second[j] += abscissa.weight[j] * b2;
        }
    }
    // Quotients of the integrals.
    const Uv1960 uv = {sum[0] / sum[2], sum[1] / sum[2]};
    const Uv1960 slope = {(first[0] - uv.u * first[2]) / sum[2], (first[1] - uv.v * first[2]) / sum[2]};
    const Uv1960 curvature = {(second[0] - 2.0 * slope.u * first[2] - uv.u * second[2]) / sum[2],
                              (second[1] - 2.0 * slope.v * first[2] - uv.v * second[2]) / sum[2]};
    return {uv, slope, curvature};
}

Uv1960 PlanckianLocus::uv(double temperature_K) const {
    require_temperature(temperature_K);
    return at(1e6 / temperature_K).uv;
}

Uv1960 PlanckianLocus::uv(const CorrelatedColorTemperature& temperature) const {
    require_temperature(temperature.temperature_K);
    if (!std::isfinite(temperature.duv)) {
        throw std::invalid_argument(fmt::format("duv = {}: expected a finite number", temperature.duv));
    }
    const Point point = at(1e6 / temperature.temperature_K);
    const double step = temperature.duv / std::hypot(point.slope.u, point.slope.v);
    return {point.uv.u - step * point.slope.v, point.uv.v + step * point.slope.u};
}

std::optional<CorrelatedColorTemperature> PlanckianLocus::nearest(const Uv1960& uv) const noexcept {
    if (!std::isfinite(uv.u) || !std::isfinite(uv.v)) return std::nullopt;

    // The nearest node: the nearest point lies between its neighbours.
    const auto squared_distance = [&](const Uv1960& node) { return dot(minus(node, uv), minus(node, uv)); };
    const auto nearest_node = std::min_element(node_uv_.begin(), node_uv_.end(), [&](const auto& a, const auto& b) {
        return squared_distance(a) < squared_distance(b);
    });
    const auto node = static_cast<std::size_t>(nearest_node - node_uv_.begin());
    if (node == 0 || node + 1 == node_uv_.size()) return std::nullopt;

    // Newton's method for the foot of the perpendicular, (P - uv) . P' = 0, kept within a shrinking bracket.
    constexpr int kMaxSteps = 60;
    double low = node_mired_[node - 1], high = node_mired_[node + 1];
    double mired = node_mired_[node];
    Point point = at(mired);
    for (int i = 0; i < kMaxSteps; ++i) {
        const Uv1960 offset = minus(point.uv, uv);
        const double rise = dot(offset, point.slope);
        (rise < 0.0 ? low : high) = mired;
        double next = mired - rise / (dot(point.slope, point.slope) + dot(offset, point.curvature));
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        const double change = std::abs(next - mired);
        mired = next;
        point = at(mired);
        if (change <= 1e-13 * mired) break;
    }

    // A little beyond the ends is within rounding of them.
    constexpr double kRounding = 1e-9;
    const double temperature_K = 1e6 / mired;
    if (temperature_K < kColdest_K * (1.0 - kRounding) || temperature_K > kHottest_K * (1.0 + kRounding))
        return std::nullopt;
    const Uv1960 offset = minus(uv, point.uv);
    const double duv = (offset.v * point.slope.u - offset.u * point.slope.v) / std::hypot(point.slope.u, point.slope.v);
    return CorrelatedColorTemperature{temperature_K, duv};
}

const PlanckianLocus& cie_1931_planckian_locus() {
    static const PlanckianLocus locus(cie_1931_2deg());
    return locus;
}

std::optional<CorrelatedColorTemperature> correlated_color_temperature(const Chromaticity& chromaticity) {
    return cie_1931_planckian_locus().nearest(uv_1960_of(chromaticity));
}

}  // namespace emulsion
