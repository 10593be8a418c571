#pragma once
// Does a routine that draws points or directions follow the density that it says? Counts in bins against the integral
// of the density over each bin, by Pearson's test.

#include <array>
#include <functional>
#include <optional>

#include "support/chi_square.h"

namespace emulsion::testing {

using SquarePoint = std::array<double, 2>;  ///< in [0, 1]^2
using Direction = std::array<double, 3>;    ///< unit vector

/// Draws by random numbers of its own; nothing: this draw yields no point, which costs the density mass.
using PointSampler = std::function<std::optional<SquarePoint>()>;
using PointDensity = std::function<double(const SquarePoint&)>;  ///< per unit of area; >= 0
using DirectionSampler = std::function<std::optional<Direction>()>;
using DirectionDensity = std::function<double(const Direction&)>;  ///< per steradian; >= 0

struct DensityCheckOptions {
    int draws = 400000;  ///< beside a tenth as many that only place the bins
    int u_bins = 16;     ///< of equal counts along the first coordinate: narrow lobes have fine bins
    int v_bins = 16;     ///< of equal width along the second
};

struct DensityCheckResult : ChiSquareResult {
    double integral = 0.0;     ///< of the density: the share of draws that yield a point
    double drawn_share = 0.0;  ///< of draws that did
};

/// The share of draws that yield a point is tested as well, against the integral: so a density that is wrong by a
/// factor is found, too. The p-value is that of both tests together, by Bonferroni. Shares are compared to within 1e-4,
/// the error of the integration.
[[nodiscard]] DensityCheckResult check_point_density(const PointSampler& sampler, const PointDensity& density,
                                                     const DensityCheckOptions& options = {});

/// The same over the sphere: the first coordinate is (1 - cos)/2 of the angle from `axis`, which is of any length but
/// 0, the second the azimuth about it. Directions within a narrow lobe about the axis are told apart down to the
/// rounding of their components.
[[nodiscard]] DensityCheckResult check_direction_density(const DirectionSampler& sampler,
                                                         const DirectionDensity& density, const Direction& axis,
                                                         const DensityCheckOptions& options = {});

}  // namespace emulsion::testing
