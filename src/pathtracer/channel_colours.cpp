#include "pathtracer/channel_colours.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/units.h"
#include "pathtracer/channel_counts.h"
#include "pathtracer/spectrum_nodes.h"

namespace emulsion {

namespace {

/// Colours along each axis of the grid.
constexpr std::size_t kSide = 17;

std::vector<double> normalised(std::vector<double> weights, const DenseSpectrum& fallback) {
    double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    const double size =
        std::accumulate(weights.begin(), weights.end(), 0.0, [](double s, double w) { return s + std::abs(w); });
    constexpr double kCancelled = 1e-4;
    if (!(std::abs(sum) > kCancelled * size)) {
        std::transform(fallback.value.begin(), fallback.value.end(), weights.begin(),
                       [](double w) { return std::abs(w); });
        sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    }
    for (double& w : weights) w /= sum;
    return weights;
}

struct GridPlace {
    std::size_t cell;
    float fraction;
};
GridPlace place_of(float value) noexcept {
    const float scaled = (value > 0.0f ? std::min(value, 1.0f) : 0.0f) * static_cast<float>(kSide - 1);
    const std::size_t cell = std::min(static_cast<std::size_t>(scaled), kSide - 2);
    return {cell, scaled - static_cast<float>(cell)};
}

}  // namespace

ChannelColours::ChannelColours(const FixedChannels& channels, const RgbSpace& space, const SigmoidTable& sigmoids) {
    if (channels.rgb_from_xyz) {
        set_linear(channels, space);
        return;
    }
    Weights weights;
    for (const auto& channel : channels.channel) {
        const Spectrum seen = product_of(channels.illuminant, channel.reflectance);
        weights.push_back(normalised(node_integrals(seen), channel.reflectance));
    }
    fill(weights, sigmoids);
}

ChannelColours::ChannelColours(const FixedChannels& channels, const RgbSpace& space, const SigmoidTable& sigmoids,
                               const Spectrum& light) {
    if (channels.rgb_from_xyz) {
        set_linear(channels, space);
        return;
    }
    Weights weights;
    for (const auto& channel : channels.channel) {
        weights.push_back(normalised(node_integrals(product_of(light, channel.light)), channel.light));
    }
    fill(weights, sigmoids);
}

void ChannelColours::set_linear(const FixedChannels& channels, const RgbSpace& space) {
    const Matrix3 matrix = *channels.rgb_from_xyz * xyz_from_rgb(space);
    for (std::size_t k = 0; k < 3; ++k) {
        const std::array<double, 3>& row = matrix.m[k];
        const double white = row[0] + row[1] + row[2];
        for (std::size_t i = 0; i < 3; ++i) {
            // The space's own channels are themselves, without what the product of matrices rounds.
            constexpr double kRounding = 1e-12;
            const double share = row[i] / white;
            of_primary_[i][k] = std::abs(share) < kRounding ? 0.0f : static_cast<float>(share);
        }
    }
}

void ChannelColours::fill(const Weights& weights, const SigmoidTable& sigmoids) {
    std::vector<double> lambda_nm(weights.front().size()), sigmoid(lambda_nm.size());
    std::iota(lambda_nm.begin(), lambda_nm.end(), static_cast<double>(kMinWavelength_nm));
    const auto values_of = [&](const RGB& rgb) {
        eval(Spectrum(sigmoid_of(sigmoids.reflectance(rgb))), lambda_nm, sigmoid);
        std::array<double, kMostFixedChannels> values{};
        for (std::size_t k = 0; k < weights.size(); ++k) {
            values[k] = std::inner_product(sigmoid.begin(), sigmoid.end(), weights[k].begin(), 0.0);
        }
        return values;
    };
    const std::array<std::array<double, kMostFixedChannels>, 3> primaries = {
        values_of({1.0f, 0.0f, 0.0f}), values_of({0.0f, 1.0f, 0.0f}), values_of({0.0f, 0.0f, 1.0f})};
    for (std::size_t i = 0; i < 3; ++i) {
        std::transform(primaries[i].begin(), primaries[i].end(), of_primary_[i].begin(),
                       [](double value) { return static_cast<float>(value); });
    }
    grid_.reserve(kSide * kSide * kSide);
    for (std::size_t b = 0; b < kSide; ++b) {
        for (std::size_t g = 0; g < kSide; ++g) {
            for (std::size_t r = 0; r < kSide; ++r) {
                const auto level = [](std::size_t i) { return static_cast<float>(i) / static_cast<float>(kSide - 1); };
                const RGB rgb{level(r), level(g), level(b)};
                const auto exact = values_of(rgb);
                ChannelValues& rest = grid_.emplace_back();
                for (std::size_t k = 0; k < weights.size(); ++k) {
                    const double linear = rgb.r * primaries[0][k] + rgb.g * primaries[1][k] + rgb.b * primaries[2][k];
                    rest[k] = static_cast<float>(exact[k] - linear);
                }
            }
        }
    }
}

template <int K>
SampledSpectrum<K> ChannelColours::at(const RGB& rgb) const noexcept {
    const auto mixed = [this](float r, float g, float b) {
        SampledSpectrum<K> values;
        for (std::size_t k = 0; k < K; ++k) {
            values.value[k] = of_primary_[0][k] * r + of_primary_[1][k] * g + of_primary_[2][k] * b;
        }
        return values;
    };
    if (grid_.empty()) return mixed(rgb.r, rgb.g, rgb.b);
    const std::array<GridPlace, 3> place = {place_of(rgb.r), place_of(rgb.g), place_of(rgb.b)};
    const auto clamped = [](const GridPlace& p) {
        return (static_cast<float>(p.cell) + p.fraction) / static_cast<float>(kSide - 1);
    };
    SampledSpectrum<K> values = mixed(clamped(place[0]), clamped(place[1]), clamped(place[2]));
    for (std::size_t corner = 0; corner < 8; ++corner) {
        float weight = 1.0f;
        std::size_t node = 0, stride = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const bool upper = ((corner >> axis) & 1u) != 0;
            weight *= upper ? place[axis].fraction : 1.0f - place[axis].fraction;
            node += (place[axis].cell + (upper ? 1 : 0)) * stride;
            stride *= kSide;
        }
        for (std::size_t k = 0; k < K; ++k) values.value[k] += weight * grid_[node][k];
    }
    return values;
}

template <int K>
SampledSpectrum<K> ChannelColours::unbounded(const RGB& rgb) const noexcept {
    if (grid_.empty()) return at<K>(rgb);
    const float scale = 2.0f * std::max({rgb.r, rgb.g, rgb.b});
    if (!(scale > 0.0f)) return SampledSpectrum<K>(0.0f);
    return at<K>({rgb.r / scale, rgb.g / scale, rgb.b / scale}) * scale;
}

#define EMULSION_INSTANTIATE(K)                                                   \
    template SampledSpectrum<K> ChannelColours::at<K>(const RGB&) const noexcept; \
    template SampledSpectrum<K> ChannelColours::unbounded<K>(const RGB&) const noexcept;
EMULSION_FOR_EACH_FIXED_CHANNEL_COUNT(EMULSION_INSTANTIATE)

}  // namespace emulsion
