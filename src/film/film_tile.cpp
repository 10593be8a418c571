#include "film/film_tile.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

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

bool all_finite(const SensorSample& sample) noexcept {
    // Sums of floats cannot overflow a double.
    return std::isfinite((static_cast<double>(sample.xyz.x) + static_cast<double>(sample.xyz.y)) +
                         (static_cast<double>(sample.xyz.z) + static_cast<double>(sample.luminance)));
}

double product(float a, float b) noexcept { return static_cast<double>(a) * static_cast<double>(b); }

void add_to(ExactSum& sum, double term) noexcept { sum += ExactSum(term); }

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
float BasicFilmTile<Sums>::kept_share(const SensorSample& sample, float max_luminance) noexcept {
    if (!all_finite(sample) || sample.luminance < 0.0f) return 0.0f;
    return sample.luminance <= max_luminance ? 1.0f : max_luminance / sample.luminance;
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
        add_to(clamped_.removed_luminance, product(weight, sample.luminance - share * sample.luminance));
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
    add_squares(i, value, weight);
    if (mean_groups_ == 0) return;
    const int place = setup_->channels.means.begin + 4 * group_;
    const std::span<ExactSum> mean = channels_.sums(i).subspan(static_cast<std::size_t>(place), 4);
    add_to(mean[0], product(weight, value.x));
    add_to(mean[1], product(weight, value.y));
    add_to(mean[2], product(weight, value.z));
    add_to(mean[3], static_cast<double>(weight));
}

template <class Sums>
void BasicFilmTile<Sums>::add_squares(std::size_t i, XYZ value, float weight) noexcept {
    const std::span<SquareSum> squares = channels_.squares(i);
    const FilmChannels::Group& of_weights = setup_->channels.squared_weights;
    const double w = of_weights.size > 0 ? product(weight, weight) : static_cast<double>(weight);
    const std::array<float, 3> all = {value.x, value.y, value.z};
    const std::span<const float> values = squares.size() == 1 ? std::span(all).subspan(1, 1) : std::span(all);
    for (std::size_t k = 0; k < squares.size(); ++k) squares[k] += SquareSum(w * product(values[k], values[k]));
    if (of_weights.size == 0) return;
    const std::span<ExactSum> sums = channels_.sums(i).subspan(static_cast<std::size_t>(of_weights.begin));
    for (std::size_t k = 0; k < squares.size(); ++k) add_to(sums[k], w * static_cast<double>(values[k]));
    add_to(sums[squares.size()], w);
}

template <class Sums>
void BasicFilmTile<Sums>::add_buckets(std::size_t i, const SensorSample& sample, const SpectralSample& spectral,
                                      float weight) noexcept {
    const auto share = static_cast<double>(kept_share(sample, max_luminance_));
    if (share == 0.0 || !std::isfinite(weight)) return;
    const SpectralBuckets& buckets = *setup_->options.spectrum;
    const std::span<ExactSum> sums = channels_.sums(i);
    for_each_bucket(spectral, buckets, [&](std::size_t bucket, double radiance, double coverage) {
        const std::size_t at = static_cast<std::size_t>(setup_->channels.buckets.begin) + 2 * bucket;
        const double weighted = static_cast<double>(weight) * coverage;
        add_to(sums[at], weighted * (share * radiance));
        add_to(sums[at + 1], weighted);
    });
}

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
        add_to(clamped_.removed_luminance, weights * removed);
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
        const std::span<ExactSum> sums = channels_.sums(i);
        const auto at = static_cast<std::size_t>(setup_->channels.light_splat.begin);
        add_to(sums[at], density * static_cast<double>(sample.xyz.x));
        add_to(sums[at + 1], density * static_cast<double>(sample.xyz.y));
        add_to(sums[at + 2], density * static_cast<double>(sample.xyz.z));
        if (!has_buckets_) return;
        for_each_bucket(spectral, *setup_->options.spectrum, [&](std::size_t bucket, double radiance, double coverage) {
            add_to(sums[static_cast<std::size_t>(setup_->channels.bucket_splats.begin) + bucket],
                   density * coverage * radiance);
        });
    });
    count_if_faint(sample.luminance);
    ++light_splats_;
}

template <class Sums>
void BasicFilmTile<Sums>::add_aux(int x, int y, std::size_t layer, std::span<const float> values,
                                  float weight) noexcept {
    if (!is_aux_value(layer, values) || !std::isfinite(weight)) {
        ++dropped_aux_;
        return;
    }
    add_aux_to(index(x, y), layer, values, weight);
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
                   [&](std::size_t i, float weight) { add_aux_to(i, layer, values, weight); });
}

template <class Sums>
bool BasicFilmTile<Sums>::is_aux_value([[maybe_unused]] std::size_t layer,
                                       std::span<const float> values) const noexcept {
    assert(layer < setup_->channels.aux.size() && values.size() == setup_->options.aux[layer].components.size());
    return std::all_of(values.begin(), values.end(), [](float value) { return std::isfinite(value); });
}

template <class Sums>
void BasicFilmTile<Sums>::add_aux_to(std::size_t i, std::size_t layer, std::span<const float> values,
                                     float weight) noexcept {
    const std::span<ExactSum> sums =
        channels_.sums(i).subspan(static_cast<std::size_t>(setup_->channels.aux[layer].begin), values.size() + 1);
    for (std::size_t k = 0; k < values.size(); ++k) add_to(sums[k], product(weight, values[k]));
    add_to(sums[values.size()], static_cast<double>(weight));
}

template <class Sums>
void BasicFilmTile<Sums>::carry_all_in_time() noexcept {
    if constexpr (kCarries) {
        if (++since_carry_ % kSamplesPerCarry != 0) [[likely]]
            return;
        for (Pixel& pixel : pixels_) pixel.carry();
    }
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
