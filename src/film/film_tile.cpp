#include "film/film_tile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "film/channel_samples.h"
#include "film/kept_share.h"

namespace emulsion {

namespace {

PixelBounds intersection(const PixelBounds& a, const PixelBounds& b) noexcept {
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

PixelBounds pixels_reached(const PixelBounds& places, const FilmSetup& setup) {
    return setup.footprint ? intersection(setup.footprint->reached_from(places), setup.bounds) : places;
}

const std::shared_ptr<const FilmSetup>& checked(const std::shared_ptr<const FilmSetup>& setup,
                                                const PixelBounds& places) {
    if (!setup) throw std::invalid_argument("film tile: setup is missing");
    if (places.width() < 1 || places.height() < 1) {
        throw std::invalid_argument("film tile of " + std::to_string(places.width()) + "x" +
                                    std::to_string(places.height()) + " pixels: both must be at least 1");
    }
    return setup;
}

std::size_t pixel_count(const PixelBounds& bounds) noexcept {
    return static_cast<std::size_t>(std::max(bounds.width(), 0)) *
           static_cast<std::size_t>(std::max(bounds.height(), 0));
}

}  // namespace

template <class Sums>
BasicFilmTile<Sums>::BasicFilmTile(PixelBounds places, std::shared_ptr<const FilmSetup> setup)
    : places_(places),
      bounds_(pixels_reached(places, *checked(setup, places))),
      least_places_{static_cast<float>(places.x0), static_cast<float>(places.y0), -static_cast<float>(places.x1),
                    -static_cast<float>(places.y1)},
      width_(bounds_.width()),
      first_(bounds_.y0 * width_ + bounds_.x0),
      setup_(std::move(setup)),
      sensor_(&setup_->sensor),
      footprint_(setup_->footprint ? &*setup_->footprint : nullptr),
      max_luminance_(setup_->max_luminance),
      has_channels_(setup_->channels.squares > 0 || setup_->mean_groups > 0),
      has_buckets_(setup_->channels.buckets.size > 0),
      has_more_(has_channels_ || setup_->footprint.has_value()),
      mean_groups_(setup_->mean_groups),
      pixels_(pixel_count(bounds_)),
      channels_(setup_->channels, pixel_count(bounds_)) {
    if (!footprint_) return;
    plain_footprint_ = has_channels_ || has_buckets_ ? nullptr : footprint_;
    constexpr float kMost = std::numeric_limits<float>::max();
    least_usual_ = Float4{-kMost, -kMost, -kMost, 0.0f};
    most_usual_ = Float4{kMost, kMost, kMost, std::min(max_luminance_, kMost)};
    weight_room_ = WeightRoom(*footprint_);
}

template <class Sums>
void BasicFilmTile<Sums>::clear() noexcept {
    std::fill(pixels_.begin(), pixels_.end(), Pixel{});
    channels_.clear();
    group_ = 0;
    since_carry_ = spread_samples_ = spread_touches_ = light_splats_ = dropped_aux_ = faint_samples_ = 0;
    dropped_ = {};
    clamped_ = {};
}

template <class Sums>
std::uint64_t BasicFilmTile<Sums>::sample_count() const noexcept {
    std::uint64_t touches = 0;
    for (const Pixel& pixel : pixels_) touches += pixel.samples();
    return touches - spread_touches_ + spread_samples_;
}

template <class Sums>
void BasicFilmTile<Sums>::accumulate_unusual(std::size_t i, int x, int y, const SensorSample& sample,
                                             float weight) noexcept {
    const float share = kept_share(sample, max_luminance_);
    if (share == 0.0f || !std::isfinite(weight)) return drop(x, y, sample, weight);
    const XYZ value = share * sample.xyz;
    pixels_[i].add(static_cast<double>(value.x), static_cast<double>(value.y), static_cast<double>(value.z),
                   static_cast<double>(weight));
    count_if_faint(sample.luminance);
    if (share < 1.0f) {
        ++clamped_.count;
        const float removed = sample.luminance - share * sample.luminance;
        clamped_.removed_luminance += ExactSum(static_cast<double>(weight) * static_cast<double>(removed));
    }
    carry_in_time(i);
    if (has_more_) add_more(i, value, weight);
}

template <class Sums>
[[gnu::cold, gnu::noinline]] void BasicFilmTile<Sums>::count_unless_black(float luminance) noexcept {
    if (luminance > 0.0f) ++faint_samples_;
}

template <class Sums>
void BasicFilmTile<Sums>::add_more(std::size_t i, XYZ value, float weight) noexcept {
    if (has_channels_) add_channels(i, value, weight);
    // Splats pass the counts by at which a pixel makes room by itself.
    if (footprint_ != nullptr) carry_all_in_time();
}

template <class Sums>
void BasicFilmTile<Sums>::add_channels(std::size_t i, XYZ value, float weight) noexcept {
    add_squares(channels_, i, value, weight);
    if (mean_groups_ > 0) add_to_mean(channels_, i, group_, value, weight);
}

template <class Sums>
void BasicFilmTile<Sums>::add_buckets(std::size_t i, const SensorSample& sample, const SpectralSample& spectral,
                                      float weight) noexcept {
    const float share = kept_share(sample, max_luminance_);
    if (share == 0.0f || !std::isfinite(weight)) return;
    add_to_buckets(channels_, i, *setup_->options.spectrum, spectral, share, weight);
}

template <class Sums>
void BasicFilmTile<Sums>::add_aux(int x, int y, std::size_t layer, std::span<const float> values,
                                  float weight) noexcept {
    if (!is_aux_value(layer, values) || !std::isfinite(weight)) {
        ++dropped_aux_;
        return;
    }
    add_to_layer(channels_, index(x, y), layer, values, weight);
}

template <class Sums>
bool BasicFilmTile<Sums>::is_aux_value([[maybe_unused]] std::size_t layer,
                                       std::span<const float> values) const noexcept {
    assert(layer < setup_->channels.aux.size() && values.size() == setup_->options.aux[layer].components.size());
    return std::all_of(values.begin(), values.end(), [](float value) { return std::isfinite(value); });
}

template <class Sums>
void BasicFilmTile<Sums>::drop(int x, int y, const SensorSample& sample, float weight) noexcept {
    const auto& [value, luminance] = sample;
    const std::array<float, 5> numbers = {value.x, value.y, value.z, luminance, weight};
    dropped_.add({x, y, kind_of_dropped(numbers), value, weight});
}

template class BasicFilmTile<ExactSums>;
template class BasicFilmTile<DoubleSums>;
template class BasicFilmTile<FloatSums>;
template class BasicFilmTile<KahanFloatSums>;

}  // namespace emulsion
