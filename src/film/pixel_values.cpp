#include "film/pixel_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace emulsion {

namespace {

std::span<const ExactSum> group_of(const PixelSums& sums, const FilmChannels::Group& group) noexcept {
    return sums.channels.subspan(static_cast<std::size_t>(group.begin), static_cast<std::size_t>(group.size));
}

/// Whether weights of so many samples leave a value; of those that had one, where not all of them have.
bool is_enough(double weight, double samples) noexcept { return weight > 0.0 && weight >= kMinMeanWeight * samples; }

/// The median by luminance; none if no group has a value.
std::optional<XYZd> median_of_means(std::span<const ExactSum> groups, std::uint32_t samples) noexcept {
    std::array<XYZd, MedianOfMeans::kMostGroups> means;
    std::size_t count = 0;
    for (std::size_t at = 0; at < groups.size(); at += 4) {
        const double weight = groups[at + 3].value();
        // A group has one in so many of the samples.
        if (!is_enough(weight, 4.0 * static_cast<double>(samples) / static_cast<double>(groups.size()))) continue;
        means[count++] = (1.0 / weight) * XYZd{groups[at].value(), groups[at + 1].value(), groups[at + 2].value()};
    }
    if (count == 0) return std::nullopt;
    const auto by_luminance = [](const XYZd& a, const XYZd& b) { return a.y < b.y; };
    std::stable_sort(means.begin(), means.begin() + static_cast<std::ptrdiff_t>(count), by_luminance);
    if (count % 2 == 1) return means[count / 2];
    return 0.5 * (means[count / 2 - 1] + means[count / 2]);
}

/// n of PixelVariance.
double effective_samples(const PixelSums& sums, const FilmSetup& setup) noexcept {
    const std::span<const ExactSum> squared_weights = group_of(sums, setup.channels.squared_weights);
    if (squared_weights.empty()) return static_cast<double>(sums.samples) / setup.mean_square_weight;
    return sums.weighted.weight * sums.weighted.weight / squared_weights.back().value();
}

/// Of the component that has square `k`; variance_of() says for which n.
double variance(const PixelSums& sums, const FilmSetup& setup, std::size_t k, double mean) noexcept {
    const double square = sums.squares[k].value();
    const std::span<const ExactSum> squared_weights = group_of(sums, setup.channels.squared_weights);
    if (squared_weights.empty()) {
        const double n = effective_samples(sums, setup);
        return std::max(0.0, n / (n - 1.0) * (square / sums.weighted.weight - mean * mean));
    }
    const double m = static_cast<double>(sums.samples), weights = squared_weights.back().value();
    const double deviations = square - mean * (2.0 * squared_weights[k].value() - mean * weights);
    return std::max(0.0, m / (m - 1.0) * (deviations / weights));
}

}  // namespace

bool has_value(const PixelSums& sums) noexcept {
    return is_enough(sums.weighted.weight, static_cast<double>(sums.samples));
}

std::optional<XYZd> mean_of(const PixelSums& sums) noexcept {
    if (!has_value(sums)) return std::nullopt;
    const auto& [xyz, weight] = sums.weighted;
    return XYZd{xyz.x / weight, xyz.y / weight, xyz.z / weight};
}

std::optional<XYZd> camera_value_of(const PixelSums& sums, const FilmSetup& setup) noexcept {
    if (setup.mean_groups == 0 || !has_value(sums)) return mean_of(sums);
    return median_of_means(group_of(sums, setup.channels.means), sums.samples);
}

XYZd light_value_of(const PixelSums& sums, const FilmSetup& setup, std::uint64_t light_paths) noexcept {
    const std::span<const ExactSum> splat = group_of(sums, setup.channels.light_splat);
    if (splat.empty() || light_paths == 0) return {};
    const auto paths = static_cast<double>(light_paths);
    return {splat[0].value() / paths, splat[1].value() / paths, splat[2].value() / paths};
}

PixelVariance variance_of(const PixelSums& sums, const FilmSetup& setup) noexcept {
    PixelVariance result;
    const std::optional<XYZd> mean = mean_of(sums);
    if (!mean || sums.samples < 2 || sums.squares.empty()) return result;
    const double n = effective_samples(sums, setup);
    // Of a ratio m is what its correction needs above 1, and n may be anything above 0: weights cancel.
    const bool is_ratio = setup.channels.squared_weights.size > 0;
    if (!(n > (is_ratio ? 0.0 : 1.0))) return result;
    const auto fill = [&](double XYZd::*component, std::size_t k) {
        result.variance.*component = variance(sums, setup, k, (*mean).*component);
        result.standard_error.*component = std::sqrt(result.variance.*component / n);
    };
    if (sums.squares.size() == 1) {
        fill(&XYZd::y, 0);
        return result;
    }
    fill(&XYZd::x, 0);
    fill(&XYZd::y, 1);
    fill(&XYZd::z, 2);
    return result;
}

std::optional<double> bucket_radiance_of(const PixelSums& sums, const FilmSetup& setup, int bucket,
                                         std::uint64_t light_paths) noexcept {
    const auto at = static_cast<std::size_t>(bucket);
    std::optional<double> radiance;
    const double covered = group_of(sums, setup.channels.buckets)[2 * at + 1].value();
    if (is_enough(covered, static_cast<double>(sums.samples))) {
        radiance = group_of(sums, setup.channels.buckets)[2 * at].value() / covered;
    }
    const std::span<const ExactSum> splats = group_of(sums, setup.channels.bucket_splats);
    if (splats.empty() || light_paths == 0) return radiance;
    return radiance.value_or(0.0) + splats[at].value() / static_cast<double>(light_paths);
}

double aux_value_of(const PixelSums& sums, const FilmSetup& setup, std::size_t layer, std::size_t component) noexcept {
    const std::span<const ExactSum> values = group_of(sums, setup.channels.aux[layer]);
    const double weight = values.back().value();
    return is_enough(weight, static_cast<double>(sums.samples)) ? values[component].value() / weight : 0.0;
}

}  // namespace emulsion
