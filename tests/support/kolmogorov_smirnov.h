#pragma once
// The Kolmogorov-Smirnov test: do numbers follow a distribution that is known in full?

#include <vector>

namespace emulsion::testing {

struct KolmogorovSmirnovResult {
    double statistic = 0.0;  ///< the largest distance between the two distribution functions; in [0, 1]
    double p_value = 1.0;    ///< of a right program looking as bad as this, or worse
};

/// Are the numbers drawn from the normal distribution of mean 0 and deviation 1? Not empty, none of them NaN.
[[nodiscard]] KolmogorovSmirnovResult normality_test(std::vector<double> z_scores);

/// The normal distribution function.
[[nodiscard]] double normal_cdf(double z);

/// P(D > statistic) for `count` numbers, by Kolmogorov's limit with a correction for finite counts: for 20 numbers and
/// more within 2% of the exact value down to 1e-3.
/// Source: Stephens, "Use of the Kolmogorov-Smirnov, Cramer-Von Mises and Related Statistics Without Extensive Tables",
/// JRSS B 32(1), 1970.
[[nodiscard]] double kolmogorov_tail(double statistic, double count);

}  // namespace emulsion::testing
