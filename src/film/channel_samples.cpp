#include "film/channel_samples.h"

#include <array>

#include "film/exact_sum.h"

namespace emulsion {

namespace {

double product(float a, float b) noexcept { return static_cast<double>(a) * static_cast<double>(b); }

void add_to(ExactSum& sum, double term) noexcept { sum += ExactSum(term); }

/// From the group's first sum on.
std::span<ExactSum> sums_from(ChannelSums& channels, std::size_t pixel, int begin) noexcept {
    return channels.sums(pixel).subspan(static_cast<std::size_t>(begin));
}

}  // namespace

void add_squares(ChannelSums& channels, std::size_t pixel, XYZ value, float weight) noexcept {
    const std::span<SquareSum> squares = channels.squares(pixel);
    const FilmChannels::Group& of_weights = channels.layout().squared_weights;
    const double w = of_weights.size > 0 ? product(weight, weight) : static_cast<double>(weight);
    const std::array<float, 3> all = {value.x, value.y, value.z};
    const std::span<const float> values = squares.size() == 1 ? std::span(all).subspan(1, 1) : std::span(all);
    for (std::size_t k = 0; k < squares.size(); ++k) squares[k] += SquareSum(w * product(values[k], values[k]));
    if (of_weights.size == 0) return;
    const std::span<ExactSum> sums = sums_from(channels, pixel, of_weights.begin);
    for (std::size_t k = 0; k < squares.size(); ++k) add_to(sums[k], w * static_cast<double>(values[k]));
    add_to(sums[squares.size()], w);
}

void add_to_mean(ChannelSums& channels, std::size_t pixel, int group, XYZ value, float weight) noexcept {
    const std::span<ExactSum> mean = sums_from(channels, pixel, channels.layout().means.begin + 4 * group);
    add_to(mean[0], product(weight, value.x));
    add_to(mean[1], product(weight, value.y));
    add_to(mean[2], product(weight, value.z));
    add_to(mean[3], static_cast<double>(weight));
}

void add_to_buckets(ChannelSums& channels, std::size_t pixel, const SpectralBuckets& buckets,
                    const SpectralSample& sample, float share, float weight) noexcept {
    const std::span<ExactSum> sums = sums_from(channels, pixel, channels.layout().buckets.begin);
    for_each_bucket(sample, buckets, [&](std::size_t bucket, double radiance, double coverage) {
        const double weighted = static_cast<double>(weight) * coverage;
        add_to(sums[2 * bucket], weighted * (static_cast<double>(share) * radiance));
        add_to(sums[2 * bucket + 1], weighted);
    });
}

void add_light(ChannelSums& channels, std::size_t pixel, XYZ value, double density) noexcept {
    const std::span<ExactSum> sums = sums_from(channels, pixel, channels.layout().light_splat.begin);
    add_to(sums[0], density * static_cast<double>(value.x));
    add_to(sums[1], density * static_cast<double>(value.y));
    add_to(sums[2], density * static_cast<double>(value.z));
}

void add_light_to_buckets(ChannelSums& channels, std::size_t pixel, const SpectralBuckets& buckets,
                          const SpectralSample& sample, double density) noexcept {
    const std::span<ExactSum> sums = sums_from(channels, pixel, channels.layout().bucket_splats.begin);
    for_each_bucket(sample, buckets, [&](std::size_t bucket, double radiance, double coverage) {
        add_to(sums[bucket], density * coverage * radiance);
    });
}

void add_to_layer(ChannelSums& channels, std::size_t pixel, std::size_t layer, std::span<const float> values,
                  float weight) noexcept {
    const std::span<ExactSum> sums = sums_from(channels, pixel, channels.layout().aux[layer].begin);
    for (std::size_t k = 0; k < values.size(); ++k) add_to(sums[k], product(weight, values[k]));
    add_to(sums[values.size()], static_cast<double>(weight));
}

}  // namespace emulsion
