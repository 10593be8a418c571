#include "pathtracer/environment_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pathtracer/equal_area.h"

namespace emulsion {

namespace {

Imath::M33d linear_part(const Imath::M44d& m) noexcept {
    return {m[0][0], m[0][1], m[0][2], m[1][0], m[1][1], m[1][2], m[2][0], m[2][1], m[2][2]};
}

/// How much light sampling is for each texel.
Image<float> sampling_weights(const Image<RGB>& texels) {
    Image<float> weights(texels.width(), texels.height(), UnsetPixels{});
    double sum = 0.0;
    for (std::size_t i = 0; i < texels.pixels().size(); ++i) {
        const RGB& texel = texels.pixels()[i];
        weights.pixels()[i] = (texel.r + texel.g + texel.b) / 3.0f;
        sum += static_cast<double>(weights.pixels()[i]);
    }
    const auto mean = static_cast<float>(sum / static_cast<double>(texels.pixels().size()));
    for (float& weight : weights.pixels()) weight = std::max(weight - mean, std::min(0.001f * mean, weight));
    return weights;
}

}  // namespace

EnvironmentMap::EnvironmentMap(const ImageInfiniteLight& light)
    : texels_(light.texels),
      light_from_world_(linear_part(light.world_from_light).inverse()),
      world_from_light_(linear_part(light.world_from_light)),
      distribution_(sampling_weights(*light.texels)),
      colours_(light.space) {}

Imath::V3f EnvironmentMap::sample(std::array<float, 2> u) const noexcept {
    return Imath::V3f((equal_area_direction(distribution_.sample(u)) * world_from_light_).normalized());
}

float EnvironmentMap::pdf(const Imath::V3f& direction) const noexcept {
    const auto [x, y] = texel_of(direction);
    return distribution_.density(x, y) * 0.25f * std::numbers::inv_pi_v<float>;
}

EnvironmentMap::Texel EnvironmentMap::texel_of(const Imath::V3f& direction) const noexcept {
    const Imath::V2d place = equal_area_place((Imath::V3d(direction) * light_from_world_).normalized());
    const auto at = [](double along, int count) {
        return std::clamp(static_cast<int>(along * static_cast<double>(count)), 0, count - 1);
    };
    return {at(place.x, texels_->width()), at(place.y, texels_->height())};
}

template <class Index>
ValuesAt<Index> EnvironmentMap::colour(const Imath::V3f& direction, const Index& index) const noexcept {
    const auto [x, y] = texel_of(direction);
    return colours_.light((*texels_)(x, y), index);
}

#define EMULSION_INSTANTIATE(TRANSPORT)                                                                    \
    template ValuesAt<TRANSPORT::Index> EnvironmentMap::colour(const Imath::V3f&, const TRANSPORT::Index&) \
        const noexcept;
EMULSION_FOR_EACH_TRANSPORT(EMULSION_INSTANTIATE)

double mean_luminance(const Image<RGB>& texels, ColorSpace space) {
    const std::array<double, 3> y = xyz_from_rgb(rgb_space_of(space)).m[1];
    double sum = 0.0;
    for (const RGB& texel : texels.pixels()) {
        sum += y[0] * static_cast<double>(texel.r) + y[1] * static_cast<double>(texel.g) +
               y[2] * static_cast<double>(texel.b);
    }
    return sum / static_cast<double>(texels.pixels().size());
}

}  // namespace emulsion
