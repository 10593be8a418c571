#include "film/film_channels.h"

#include <algorithm>

namespace emulsion {

FilmChannels::FilmChannels(const FilmOptions& options)
    : squares(options.variance == FilmVariance::none ? 0 : (options.variance == FilmVariance::luminance ? 1 : 3)) {
    const auto place = [this](int size) {
        const Group group{sums, size};
        sums += size;
        return group;
    };
    const int bucket_count = options.spectrum ? options.spectrum->count : 0;
    light_splat = place(options.light_splats ? 3 : 0);
    buckets = place(2 * bucket_count);
    bucket_splats = place(options.light_splats ? bucket_count : 0);
    for (const AuxLayer& layer : options.aux) aux.push_back(place(static_cast<int>(layer.components.size()) + 1));
    const auto* const median = std::get_if<MedianOfMeans>(&options.firefly_control);
    means = place(median != nullptr ? 4 * median->groups : 0);
    squared_weights = place(squares > 0 && has_negative_lobes(options.filter) ? squares + 1 : 0);
}

ChannelSums::ChannelSums(const FilmChannels& channels, std::size_t pixels)
    : layout_(channels),
      sums_per_pixel_(static_cast<std::size_t>(channels.sums)),
      squares_per_pixel_(static_cast<std::size_t>(channels.squares)),
      sums_(pixels * sums_per_pixel_),
      squares_(pixels * squares_per_pixel_) {}

void ChannelSums::add(std::size_t to, const ChannelSums& other, std::size_t from, std::size_t count) noexcept {
    for (std::size_t i = 0; i < count * sums_per_pixel_; ++i) {
        sums_[to * sums_per_pixel_ + i] += other.sums_[from * sums_per_pixel_ + i];
    }
    for (std::size_t i = 0; i < count * squares_per_pixel_; ++i) {
        squares_[to * squares_per_pixel_ + i] += other.squares_[from * squares_per_pixel_ + i];
    }
}

void ChannelSums::clear() noexcept {
    std::fill(sums_.begin(), sums_.end(), ExactSum{});
    std::fill(squares_.begin(), squares_.end(), SquareSum{});
}

bool ChannelSums::is_saturated(std::size_t pixel) const noexcept {
    const auto saturated = [](const auto& sum) { return sum.is_saturated(); };
    return std::any_of(sums(pixel).begin(), sums(pixel).end(), saturated) ||
           std::any_of(squares(pixel).begin(), squares(pixel).end(), saturated);
}

}  // namespace emulsion
