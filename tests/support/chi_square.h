#pragma once
// Pearson's chi-square test: do counts follow the counts that were expected? A p-value is the probability with which a
// right program would look as bad as this one, or worse.

#include <span>

namespace emulsion::testing {

struct ChiSquareResult {
    double statistic = 0.0;           ///< sum of (observed - expected)^2 / expected over the pooled bins; >= 0
    double degrees_of_freedom = 0.0;  ///< pooled bins - 1; >= 0
    /// In [0, 1]; 0 if something fell where nothing may; 1 if all is in one bin, which says nothing.
    double p_value = 1.0;
};

/// Below this expected count the distribution of a bin is no longer close enough to normal (Cochran's rule).
inline constexpr double kLeastExpectedCount = 5.0;

/// Bins that expect fewer than kLeastExpectedCount are pooled, the emptiest first, until their sum expects that many.
/// Bins that expect nothing take part with what they hold: anything in them makes the p-value 0.
/// \throws std::invalid_argument unless both are of one size, finite and >= 0, and their sums agree to 1e-4 of the
/// larger.
[[nodiscard]] ChiSquareResult chi_square_test(std::span<const double> observed, std::span<const double> expected);

/// P(X > statistic) for chi-square X. Exact to 1e-12.
[[nodiscard]] double chi_square_tail(double statistic, double degrees_of_freedom);

/// Q(a, x), the regularised upper incomplete gamma function; a > 0, x >= 0. Exact to 1e-12.
/// Source: Abramowitz & Stegun, "Handbook of Mathematical Functions", 6.5.29 (series) and 6.5.31 (continued fraction).
[[nodiscard]] double upper_incomplete_gamma(double a, double x);

/// The p-value below which one of `tests` independent tests fails, so that all of them together raise a false alarm
/// with probability `false_alarm`. Source: Sidak, "Rectangular Confidence Regions for the Means of Multivariate Normal
/// Distributions", JASA 62, 1967.
[[nodiscard]] double sidak_level(double false_alarm, int tests);

}  // namespace emulsion::testing
