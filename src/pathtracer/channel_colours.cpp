#include "pathtracer/channel_colours.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "core/units.h"
#include "pathtracer/channel_counts.h"
#include "pathtracer/spectrum_nodes.h"

namespace emulsion {

namespace {

/// Colours along each axis of the grid.
constexpr std::size_t kSide = 17;

std::array<double, 3> product(const std::array<double, 3>& row, const Matrix3& matrix) noexcept {
    std::array<double, 3> result{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) result[i] += row[j] * matrix.m[j][i];
    }
    return result;
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
    Weights weights;
    for (const FixedChannel& channel : channels) {
        weights.push_back(channel.colour_from_xyz ? std::vector<double>{} : channel.reflectance);
    }
    fill(channels, space, weights, sigmoids);
}

ChannelColours::ChannelColours(const FixedChannels& channels, const RgbSpace& space, const SigmoidTable& sigmoids,
                               const Spectrum& light) {
    const std::vector<double> nodes = node_integrals(light);
    Weights weights;
    for (const FixedChannel& channel : channels) {
        std::vector<double>& seen = weights.emplace_back();
        if (channel.colour_from_xyz) continue;
        seen = channel.light;
        std::transform(seen.begin(), seen.end(), nodes.begin(), seen.begin(), std::multiplies<>());
        seen = normalised_weights(std::move(seen));
    }
    fill(channels, space, weights, sigmoids);
}

void ChannelColours::fill(const FixedChannels& channels, const RgbSpace& space, const Weights& weights,
                          const SigmoidTable& sigmoids) {
    const Matrix3 xyz_from_colour = xyz_from_rgb(space);
    for (std::size_t k = 0; k < channels.size(); ++k) {
        if (!channels[k].colour_from_xyz) continue;
        const std::array<double, 3> row = product(*channels[k].colour_from_xyz, xyz_from_colour);
        const double white = row[0] + row[1] + row[2];
        for (std::size_t i = 0; i < 3; ++i) {
            // The space's own channels are themselves, without what the product of matrices rounds.
            constexpr double kRounding = 1e-12;
            const double share = row[i] / white;
            of_primary_[i][k] = std::abs(share) < kRounding ? 0.0f : static_cast<float>(share);
        }
    }
    const auto is_colour = [](const FixedChannel& channel) { return channel.colour_from_xyz.has_value(); };
    if (std::all_of(channels.begin(), channels.end(), is_colour)) return;

    std::vector<double> lambda_nm(kWholeNanometres), sigmoid(kWholeNanometres);
    std::iota(lambda_nm.begin(), lambda_nm.end(), static_cast<double>(kMinWavelength_nm));
    const auto values_of = [&](const RGB& rgb) {
        eval(Spectrum(sigmoid_of(sigmoids.reflectance(rgb))), lambda_nm, sigmoid);
        ChannelValues values{};
        for (std::size_t k = 0; k < weights.size(); ++k) {
            values[k] = std::inner_product(weights[k].begin(), weights[k].end(), sigmoid.begin(), 0.0);
        }
        return values;
    };
    const std::array<ChannelValues, 3> primaries = {values_of({1.0f, 0.0f, 0.0f}), values_of({0.0f, 1.0f, 0.0f}),
                                                    values_of({0.0f, 0.0f, 1.0f})};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < channels.size(); ++k) {
            if (!is_colour(channels[k])) of_primary_[i][k] = static_cast<float>(primaries[i][k]);
        }
    }
    stride_ = static_cast<std::size_t>(compiled_channels(static_cast<int>(weights.size())));
    grid_.reserve(kSide * kSide * kSide * stride_);
    for (std::size_t b = 0; b < kSide; ++b) {
        for (std::size_t g = 0; g < kSide; ++g) {
            for (std::size_t r = 0; r < kSide; ++r) {
                const auto level = [](std::size_t i) { return static_cast<float>(i) / static_cast<float>(kSide - 1); };
                const RGB rgb{level(r), level(g), level(b)};
                const auto exact = values_of(rgb);
                for (std::size_t k = 0; k < stride_; ++k) {
                    const double linear = rgb.r * primaries[0][k] + rgb.g * primaries[1][k] + rgb.b * primaries[2][k];
                    grid_.push_back(static_cast<float>(exact[k] - linear));
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
        for (std::size_t k = 0; k < K; ++k) values.value[k] += weight * grid_[node * stride_ + k];
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
