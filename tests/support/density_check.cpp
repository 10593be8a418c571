#include "support/density_check.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <vector>

namespace emulsion::testing {

namespace {

/// What the integral of a density may be off by.
constexpr double kIntegralError = 1e-4;

struct Cell {
    double u0, u1, v0, v1;
};

/// Simpson's rule of 3 x 3 points, the outer ones a little inside. Rules that leave the corners out, such as Gauss's,
/// agree with their own halves on an edge of the density near a corner, and miss what lies behind it.
double simpson(const PointDensity& density, const Cell& cell) {
    constexpr std::array<double, 3> kPlace = {1e-6, 0.5, 1.0 - 1e-6};
    constexpr std::array<double, 3> kWeight = {1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0};
    const double width = cell.u1 - cell.u0, height = cell.v1 - cell.v0;
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            sum += kWeight[i] * kWeight[j] * density({cell.u0 + kPlace[i] * width, cell.v0 + kPlace[j] * height});
        }
    }
    return sum * width * height;
}

/// The integral over a cell, whose first guess is `coarse`: it is halved across the side along which that changes the
/// guess more, until neither does. So edges along a coordinate are found by bisection.
double integral(const PointDensity& density, const Cell& cell, double coarse, double tolerance, int splits_left) {
    const double u = 0.5 * (cell.u0 + cell.u1), v = 0.5 * (cell.v0 + cell.v1);
    const std::array<std::array<Cell, 2>, 2> halves = {
        {{{{cell.u0, u, cell.v0, cell.v1}, {u, cell.u1, cell.v0, cell.v1}}},
         {{{cell.u0, cell.u1, cell.v0, v}, {cell.u0, cell.u1, v, cell.v1}}}}};
    std::array<std::array<double, 2>, 2> parts{};
    std::array<double, 2> sum{};
    for (std::size_t side = 0; side < 2; ++side) {
        for (std::size_t i = 0; i < 2; ++i) sum[side] += parts[side][i] = simpson(density, halves[side][i]);
    }
    const std::size_t side = std::abs(sum[0] - coarse) >= std::abs(sum[1] - coarse) ? 0 : 1;
    if (splits_left == 0 || std::abs(sum[side] - coarse) <= tolerance) return sum[side];
    return integral(density, halves[side][0], parts[side][0], tolerance, splits_left - 1) +
           integral(density, halves[side][1], parts[side][1], tolerance, splits_left - 1);
}

/// Every bin is split into 4 x 4 unasked, so that what lies between nine points is not overlooked.
double integral_over_bin(const PointDensity& density, const Cell& bin, double tolerance) {
    constexpr int kParts = 4, kMostSplits = 40;
    const double width = (bin.u1 - bin.u0) / kParts, height = (bin.v1 - bin.v0) / kParts;
    double sum = 0.0;
    for (int i = 0; i < kParts; ++i) {
        for (int j = 0; j < kParts; ++j) {
            const Cell part = {bin.u0 + i * width, bin.u0 + (i + 1) * width, bin.v0 + j * height,
                               bin.v0 + (j + 1) * height};
            sum += integral(density, part, simpson(density, part), tolerance, kMostSplits);
        }
    }
    return sum;
}

/// Edges of bins from 0 to 1: with about equal counts between the least and the largest of the points, and ever wider
/// outside. Few points or none: of equal width.
std::vector<double> bin_edges(std::vector<double> places, int bins) {
    std::vector<double> edges = {0.0, 1.0};
    if (places.size() < 100) {
        for (int i = 1; i < bins; ++i) edges.push_back(static_cast<double>(i) / bins);
    } else {
        std::sort(places.begin(), places.end());
        for (int i = 1; i < bins; ++i)
            edges.push_back(places[places.size() * static_cast<std::size_t>(i) / static_cast<std::size_t>(bins)]);
        const double range = std::max(places.back() - places.front(), 1e-12);
        for (double step = 0.01 * range; step < 1.0; step *= 4.0) {
            edges.push_back(std::max(places.front() - step, 0.0));
            edges.push_back(std::min(places.back() + step, 1.0));
        }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

std::size_t bin_of(const std::vector<double>& edges, double u) {
    const auto above = std::upper_bound(edges.begin() + 1, edges.end() - 1, u);
    return static_cast<std::size_t>(above - edges.begin()) - 1;
}

using Vector = std::array<double, 3>;
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector normalised(const Vector& a) {
    const double length = std::sqrt(dot(a, a));
    return {a[0] / length, a[1] / length, a[2] / length};
}

/// The p-value of the number of draws that yielded a point, which is binomial, by its normal limit.
double share_p_value(const DensityCheckResult& result, int draws) {
    const double excess = std::abs(result.drawn_share - result.integral) - kIntegralError;
    if (excess <= 0.0) return 1.0;
    const double variance = std::max(0.0, result.integral * (1.0 - result.integral)) / draws;
    return std::erfc(excess / std::sqrt(2.0 * variance));
}

/// Directions about an axis as points of the unit square, and back: areas are solid angles over 4 pi.
struct Polar {
    Vector x, y, z;

    explicit Polar(const Direction& axis) : x{}, y{}, z(normalised(axis)) {
        const Vector aside = std::abs(z[0]) < 0.5 ? Vector{1, 0, 0} : Vector{0, 1, 0};
        x = normalised(cross(aside, z));
        y = cross(z, x);
    }
    [[nodiscard]] SquarePoint point(const Direction& direction) const {
        // From the chord: 1 - cos would lose the digits of small angles.
        const Vector unit = normalised(direction);
        const Vector chord = {unit[0] - z[0], unit[1] - z[1], unit[2] - z[2]};
        const double turn = std::atan2(dot(unit, y), dot(unit, x)) / (2.0 * std::numbers::pi);
        return {std::min(0.25 * dot(chord, chord), 1.0), turn < 0.0 ? turn + 1.0 : turn};
    }
    [[nodiscard]] Direction direction(const SquarePoint& point) const {
        const double cosine = 1.0 - 2.0 * point[0], sine = 2.0 * std::sqrt(point[0] * (1.0 - point[0]));
        const double a = sine * std::cos(2.0 * std::numbers::pi * point[1]);
        const double b = sine * std::sin(2.0 * std::numbers::pi * point[1]);
        return {a * x[0] + b * y[0] + cosine * z[0], a * x[1] + b * y[1] + cosine * z[1],
                a * x[2] + b * y[2] + cosine * z[2]};
    }
};

}  // namespace

DensityCheckResult check_point_density(const PointSampler& sampler, const PointDensity& density,
                                       const DensityCheckOptions& options) {
    // Where the bins are.
    std::vector<double> pilot;
    for (int i = 0; i < options.draws / 10; ++i) {
        if (const auto point = sampler()) pilot.push_back((*point)[0]);
    }
    const std::vector<double> edges = bin_edges(std::move(pilot), options.u_bins);
    const std::size_t v_bins = static_cast<std::size_t>(options.v_bins), bins = (edges.size() - 1) * v_bins;

    // What is in them.
    std::vector<double> observed(bins);
    for (int i = 0; i < options.draws; ++i) {
        const auto point = sampler();
        if (!point) continue;
        const auto v = static_cast<std::size_t>((*point)[1] * static_cast<double>(v_bins));
        observed[bin_of(edges, (*point)[0]) * v_bins + std::min(v, v_bins - 1)] += 1.0;
    }

    // What should be in them: each part exact to a fiftieth of a count.
    std::vector<double> expected(bins);
    DensityCheckResult result;
    for (std::size_t bin = 0; bin < bins; ++bin) {
        const std::size_t u = bin / v_bins;
        const double v = static_cast<double>(bin % v_bins);
        const Cell cell = {edges[u], edges[u + 1], v / options.v_bins, (v + 1.0) / options.v_bins};
        expected[bin] = integral_over_bin(density, cell, 0.02 / options.draws);
        result.integral += expected[bin];
    }
    // How many yield something, and where those are: two tests, of which the worse counts twice.
    const double drawn = std::accumulate(observed.begin(), observed.end(), 0.0);
    result.drawn_share = drawn / options.draws;
    if (result.integral == 0.0) {
        result.p_value = drawn > 0.0 ? 0.0 : 1.0;
        return result;
    }
    for (double& count : expected) count *= drawn / result.integral;
    static_cast<ChiSquareResult&>(result) = chi_square_test(observed, expected);
    result.p_value = std::min(1.0, 2.0 * std::min(result.p_value, share_p_value(result, options.draws)));
    return result;
}

DensityCheckResult check_direction_density(const DirectionSampler& sampler, const DirectionDensity& density,
                                           const Direction& axis, const DensityCheckOptions& options) {
    const Polar polar(axis);
    const auto point_sampler = [&]() -> std::optional<SquarePoint> {
        const auto direction = sampler();
        if (!direction) return std::nullopt;
        return polar.point(*direction);
    };
    const auto point_density = [&](const SquarePoint& point) {
        return 4.0 * std::numbers::pi * density(polar.direction(point));
    };
    return check_point_density(point_sampler, point_density, options);
}

}  // namespace emulsion::testing
