#pragma once
// How integrals over a wavelength are summed: interval by interval between the knots of everything in the integrand, by
// Gauss's rule of the degree that is exact there, or, for what is no polynomial, by Kronrod's on panels that are halved
// until it agrees with Gauss's. Several integrals over the same wavelengths (X, Y and Z) are summed at once.
//
// Rules have no points at the ends of a panel, so that jumps at knots need no care; and wavelengths are offsets from
// the knot below, so that intervals may be as narrow as they like.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "spectrum/spectrum_wavelengths.h"

namespace emulsion {

/// K integrals, or integrands.
template <std::size_t K>
using Sums = std::array<double, K>;

/// Points in (0, 1) and their weights, whose sum is 1.
struct QuadratureRule {
    std::vector<double> point, weight;
};

/// The largest degree that gauss_rule integrates exactly, with 8 points.
inline constexpr int kMaxGaussDegree = 15;

/// Gauss and Legendre's rule with the fewest points, exact for polynomials of this degree; [0, kMaxGaussDegree].
[[nodiscard]] const QuadratureRule& gauss_rule(int degree) noexcept;

/// Kronrod's seven points, exact to degree 11, and the weights that Gauss's three of them (the others' are 0) have.
/// Source: Kronrod, "Nodes and Weights of Quadrature Formulas", 1965.
struct KronrodRule {
    std::array<double, 7> point, weight, gauss_weight;
};
[[nodiscard]] const KronrodRule& kronrod_rule() noexcept;

/// A stretch of wavelengths from base_nm + start_nm on.
struct Panel {
    double base_nm = 0.0, start_nm = 0.0, width_nm = 0.0;
};

/// The integrand's values at the points of a rule. Integrand: void(const OffsetWavelengths&, std::span<Sums<K>>).
template <std::size_t K, std::size_t Count, class Integrand>
void values_at(const Integrand& integrand, const Panel& panel, std::span<const double> points,
               std::array<Sums<K>, Count>& values) {
    std::array<double, Count> offset_nm{};
    for (std::size_t i = 0; i < points.size(); ++i) offset_nm[i] = panel.start_nm + panel.width_nm * points[i];
    integrand(OffsetWavelengths{panel.base_nm, std::span(offset_nm).first(points.size())},
              std::span(values).first(points.size()));
}

template <std::size_t K, class Integrand>
Sums<K> gauss_sum(const Integrand& integrand, const Panel& panel, const QuadratureRule& rule) {
    std::array<Sums<K>, (kMaxGaussDegree + 1) / 2> values{};
    values_at<K>(integrand, panel, rule.point, values);
    Sums<K> sum{};
    for (std::size_t i = 0; i < rule.point.size(); ++i) {
        for (std::size_t k = 0; k < K; ++k) sum[k] += panel.width_nm * rule.weight[i] * values[i][k];
    }
    return sum;
}

/// One panel by Kronrod's rule.
template <std::size_t K>
struct PanelEstimate {
    Panel panel;
    Sums<K> value{};       // by Kronrod's rule
    Sums<K> difference{};  // to Gauss's
    Sums<K> magnitude{};   // integral of the absolute value
};

template <std::size_t K, class Integrand>
PanelEstimate<K> kronrod_estimate(const Integrand& integrand, const Panel& panel) {
    const KronrodRule& rule = kronrod_rule();
    std::array<Sums<K>, 7> values{};
    values_at<K>(integrand, panel, rule.point, values);
    PanelEstimate<K> estimate{panel, {}, {}, {}};
    for (std::size_t k = 0; k < K; ++k) {
        double kronrod = 0.0, difference = 0.0, magnitude = 0.0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            kronrod += rule.weight[i] * values[i][k];
            difference += (rule.weight[i] - rule.gauss_weight[i]) * values[i][k];
            magnitude += rule.weight[i] * std::abs(values[i][k]);
        }
        estimate.value[k] = panel.width_nm * kronrod;
        estimate.difference[k] = panel.width_nm * std::abs(difference);
        estimate.magnitude[k] = panel.width_nm * magnitude;
    }
    return estimate;
}

/// Whether the rules agree to 1e-10 of the panel's magnitude, or to `negligible`. Kronrod's is then far closer.
template <std::size_t K>
bool is_fine(const PanelEstimate<K>& estimate, const Sums<K>& negligible) noexcept {
    for (std::size_t k = 0; k < K; ++k) {
        if (estimate.difference[k] > std::max(1e-10 * estimate.magnitude[k], negligible[k])) return false;
    }
    return true;
}

/// Whether halving a panel hardly helped, though the rules nearly agree. Halving divides their difference by 64 or more
/// where the integrand is as good as a polynomial, so that it can be so once or twice at most, unless by rounding.
template <std::size_t K>
bool has_stalled(const PanelEstimate<K>& whole, const PanelEstimate<K>& left, const PanelEstimate<K>& right) noexcept {
    for (std::size_t k = 0; k < K; ++k) {
        const double halves = left.difference[k] + right.difference[k];
        const bool is_small = whole.difference[k] <= 1e-5 * whole.magnitude[k];
        if (!is_small || halves <= 0.25 * whole.difference[k]) return false;
    }
    return true;
}

/// How often a panel may still be halved: in all, and without getting closer. Without the second, an integrand that is
/// rounded to less than 1e-10 (sigmoids of huge coefficients) would be halved for very long.
struct Halvings {
    int left = 16;
    int stalls_left = 3;
};

/// The estimate's panel, halved until it is fine.
template <std::size_t K, class Integrand>
Sums<K> refined(const Integrand& integrand, const PanelEstimate<K>& estimate, const Sums<K>& negligible,
                Halvings allowed) {
    if (allowed.left == 0 || allowed.stalls_left == 0 || is_fine(estimate, negligible)) return estimate.value;
    const auto& [base_nm, start_nm, width_nm] = estimate.panel;
    const double half_nm = 0.5 * width_nm;
    const auto left = kronrod_estimate<K>(integrand, Panel{base_nm, start_nm, half_nm});
    const auto right = kronrod_estimate<K>(integrand, Panel{base_nm, start_nm + half_nm, half_nm});
    --allowed.left;
    allowed.stalls_left = has_stalled(estimate, left, right) ? allowed.stalls_left - 1 : Halvings{}.stalls_left;
    const Sums<K> a = refined<K>(integrand, left, negligible, allowed);
    const Sums<K> b = refined<K>(integrand, right, negligible, allowed);
    Sums<K> sum{};
    for (std::size_t k = 0; k < K; ++k) sum[k] = a[k] + b[k];
    return sum;
}

/// The integral from the first cut to the last, for an integrand that is smooth between neighbouring cuts: a polynomial
/// of this degree, or, if unset, any smooth function without features much narrower than their distance.
template <std::size_t K, class Integrand>
[[nodiscard]] Sums<K> integral_over_cuts(std::span<const double> cuts_nm, std::optional<int> degree,
                                         const Integrand& integrand) {
    Sums<K> sum{};
    const auto add = [&sum](const Sums<K>& part) {
        for (std::size_t k = 0; k < K; ++k) sum[k] += part[k];
    };
    if (degree && *degree <= kMaxGaussDegree) {
        for (std::size_t i = 0; i + 1 < cuts_nm.size(); ++i) {
            const Panel panel = {cuts_nm[i], 0.0, cuts_nm[i + 1] - cuts_nm[i]};
            add(gauss_sum<K>(integrand, panel, gauss_rule(*degree)));
        }
        return sum;
    }

    // A first look, to know what is negligible.
    constexpr double kWidest_nm = 20.0, kMostPanels = 4096.0;
    std::vector<PanelEstimate<K>> estimates;
    for (std::size_t i = 0; i + 1 < cuts_nm.size(); ++i) {
        const double width_nm = cuts_nm[i + 1] - cuts_nm[i];
        const int count = static_cast<int>(std::clamp(std::ceil(width_nm / kWidest_nm), 1.0, kMostPanels));
        const double step_nm = width_nm / count;
        for (int j = 0; j < count; ++j) {
            estimates.push_back(kronrod_estimate<K>(integrand, Panel{cuts_nm[i], j * step_nm, step_nm}));
        }
    }
    Sums<K> negligible{};
    for (const PanelEstimate<K>& estimate : estimates) {
        for (std::size_t k = 0; k < K; ++k) negligible[k] += 1e-14 * estimate.magnitude[k];
    }
    for (const PanelEstimate<K>& estimate : estimates) add(refined<K>(integrand, estimate, negligible, Halvings{}));
    return sum;
}

}  // namespace emulsion
