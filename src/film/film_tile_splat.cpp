// What goes into a tile by place, not by pixel: it is spread over all that the film's filter reaches from there.

#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

#include "film/channel_samples.h"
#include "film/film_tile.h"
#include "film/kept_share.h"

namespace emulsion {

template <class Sums>
void BasicFilmTile<Sums>::spread(float x_px, float y_px, const SensorSample& sample,
                                 const SpectralSample& spectral) noexcept {
    assert(setup_->options.filter_use == FilterUse::splatted && has_place(x_px, y_px));
    if (!spread_quickly(x_px, y_px, sample)) [[unlikely]]
        spread_any(x_px, y_px, sample, spectral);
}

template <class Sums>
bool BasicFilmTile<Sums>::spread_quickly(float x_px, float y_px, const SensorSample& sample) noexcept {
    if constexpr (requires { &Pixel::add_four_by_four; }) {
        const auto numbers = std::bit_cast<Float4>(sample);
        if (!plain_footprint_ || !has_place(x_px, y_px)) return false;
        if (!all((numbers >= least_usual_) & (numbers <= most_usual_))) return false;
        const auto block = plain_footprint_->four_by_four(x_px, y_px);
        if (!block || !bounds_.contains(block->x_px, block->y_px)) return false;
        if (!bounds_.contains(block->x_px + 3, block->y_px + 3)) return false;
        Pixel::add_four_by_four(&pixels_[index(block->x_px, block->y_px)], width_, block->x_weights, block->y_weights,
                                numbers);
        count_if_faint(sample.luminance);
        spread_touches_ += 16;
        ++spread_samples_;
        carry_all_in_time();
        return true;
    }
    return false;
}

template <class Sums>
void BasicFilmTile<Sums>::spread_any(float x_px, float y_px, const SensorSample& sample,
                                     const SpectralSample& spectral) noexcept {
    if (!footprint_ || !has_place(x_px, y_px)) return;
    const float share = kept_share(sample, max_luminance_);
    if (share == 0.0f) {
        return drop(static_cast<int>(std::floor(x_px)), static_cast<int>(std::floor(y_px)), sample, 1.0f);
    }
    const XYZ value = share * sample.xyz;
    const XYZd exact_value{static_cast<double>(value.x), static_cast<double>(value.y), static_cast<double>(value.z)};
    const SplatBlock block = block_reached(*footprint_, bounds_, x_px, y_px, weight_room_);
    if (share < 1.0f) {
        const auto removed = static_cast<double>(sample.luminance - share * sample.luminance);
        double weights = 0.0;
        for_each_pixel(block, [&](std::size_t, float weight) { weights += static_cast<double>(weight); });
        ++clamped_.count;
        clamped_.removed_luminance += ExactSum(weights * removed);
    }
    add_block(std::span(pixels_), block, exact_value);
    spread_touches_ += block.size();
    if (has_channels_ || has_buckets_) [[unlikely]] {
        for_each_pixel(block, [&](std::size_t i, float weight) {
            if (has_channels_) add_channels(i, value, weight);
            if (has_buckets_) add_buckets(i, sample, spectral, weight);
        });
    }
    count_if_faint(sample.luminance);
    ++spread_samples_;
    carry_all_in_time();
}

template <class Sums>
void BasicFilmTile<Sums>::splat_light(float x_px, float y_px, const SensorSample& sample,
                                      const SpectralSample& spectral) noexcept {
    assert(setup_->options.light_splats);
    if (setup_->channels.light_splat.size == 0 || !has_place(x_px, y_px)) return;
    if (kept_share(sample, std::numeric_limits<float>::infinity()) == 0.0f) {
        return drop(static_cast<int>(std::floor(x_px)), static_cast<int>(std::floor(y_px)), sample, 1.0f);
    }
    const double per_area = 1.0 / footprint_->area_px();
    for_each_pixel(block_reached(*footprint_, bounds_, x_px, y_px, weight_room_), [&](std::size_t i, float weight) {
        const double density = static_cast<double>(weight) * per_area;
        add_light(channels_, i, sample.xyz, density);
        if (has_buckets_) add_light_to_buckets(channels_, i, *setup_->options.spectrum, spectral, density);
    });
    count_if_faint(sample.luminance);
    ++light_splats_;
}

template <class Sums>
void BasicFilmTile<Sums>::add_aux_at(float x_px, float y_px, std::size_t layer,
                                     std::span<const float> values) noexcept {
    assert(setup_->options.filter_use == FilterUse::splatted && has_place(x_px, y_px));
    if (!footprint_ || !has_place(x_px, y_px)) return;
    if (!is_aux_value(layer, values)) {
        ++dropped_aux_;
        return;
    }
    for_each_pixel(block_reached(*footprint_, bounds_, x_px, y_px, weight_room_),
                   [&](std::size_t i, float weight) { add_to_layer(channels_, i, layer, values, weight); });
}

// Member by member: film_tile.cpp instantiates the class, without those that it has no definition of.
template void BasicFilmTile<ExactSums>::spread(float, float, const SensorSample&, const SpectralSample&) noexcept;
template void BasicFilmTile<DoubleSums>::spread(float, float, const SensorSample&, const SpectralSample&) noexcept;
template void BasicFilmTile<FloatSums>::spread(float, float, const SensorSample&, const SpectralSample&) noexcept;
template void BasicFilmTile<KahanFloatSums>::spread(float, float, const SensorSample&, const SpectralSample&) noexcept;
template bool BasicFilmTile<ExactSums>::spread_quickly(float, float, const SensorSample&) noexcept;
template bool BasicFilmTile<DoubleSums>::spread_quickly(float, float, const SensorSample&) noexcept;
template bool BasicFilmTile<FloatSums>::spread_quickly(float, float, const SensorSample&) noexcept;
template bool BasicFilmTile<KahanFloatSums>::spread_quickly(float, float, const SensorSample&) noexcept;
template void BasicFilmTile<ExactSums>::spread_any(float, float, const SensorSample&, const SpectralSample&) noexcept;
template void BasicFilmTile<DoubleSums>::spread_any(float, float, const SensorSample&, const SpectralSample&) noexcept;
template void BasicFilmTile<FloatSums>::spread_any(float, float, const SensorSample&, const SpectralSample&) noexcept;
template void BasicFilmTile<KahanFloatSums>::spread_any(float, float, const SensorSample&,
                                                        const SpectralSample&) noexcept;
template void BasicFilmTile<ExactSums>::splat_light(float, float, const SensorSample&, const SpectralSample&) noexcept;
template void BasicFilmTile<DoubleSums>::splat_light(float, float, const SensorSample&, const SpectralSample&) noexcept;
template void BasicFilmTile<FloatSums>::splat_light(float, float, const SensorSample&, const SpectralSample&) noexcept;
template void BasicFilmTile<KahanFloatSums>::splat_light(float, float, const SensorSample&,
                                                         const SpectralSample&) noexcept;
template void BasicFilmTile<ExactSums>::add_aux_at(float, float, std::size_t, std::span<const float>) noexcept;
template void BasicFilmTile<DoubleSums>::add_aux_at(float, float, std::size_t, std::span<const float>) noexcept;
template void BasicFilmTile<FloatSums>::add_aux_at(float, float, std::size_t, std::span<const float>) noexcept;
template void BasicFilmTile<KahanFloatSums>::add_aux_at(float, float, std::size_t, std::span<const float>) noexcept;

}  // namespace emulsion
