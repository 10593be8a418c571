#include "film/film_tile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

namespace emulsion {

template <class Sums>
BasicFilmTile<Sums>::BasicFilmTile(PixelBounds bounds, std::shared_ptr<const Sensor> sensor)
    : bounds_(bounds), width_(bounds.width()), first_(bounds.y0 * width_ + bounds.x0), sensor_(std::move(sensor)) {
    if (bounds.width() < 1 || bounds.height() < 1) {
        throw std::invalid_argument("film tile of " + std::to_string(bounds.width()) + "x" +
                                    std::to_string(bounds.height()) + " pixels: both must be at least 1");
    }
    if (!sensor_) throw std::invalid_argument("film tile: sensor is missing");
    const std::size_t count = static_cast<std::size_t>(bounds.width()) * static_cast<std::size_t>(bounds.height());
    pixels_.resize(count);
    sample_counts_.resize(count);
}

template <class Sums>
void BasicFilmTile<Sums>::clear() noexcept {
    std::fill(pixels_.begin(), pixels_.end(), Pixel{});
    std::fill(sample_counts_.begin(), sample_counts_.end(), 0u);
    dropped_ = {};
}

template <class Sums>
void BasicFilmTile<Sums>::carry(std::size_t i) noexcept {
    if constexpr (requires(Pixel & pixel) { pixel.carry(); }) pixels_[i].carry();
    sample_counts_[i] = std::min(sample_counts_[i], kMostSamples);
}

template <class Sums>
void BasicFilmTile<Sums>::drop(int x, int y, XYZ value, float weight) noexcept {
    DroppedKind kind = DroppedKind::negative_luminance;
    const std::array<float, 4> numbers = {value.x, value.y, value.z, weight};
    if (std::any_of(numbers.begin(), numbers.end(), [](float v) { return std::isinf(v); })) {
        kind = DroppedKind::infinite;
    }
    if (std::any_of(numbers.begin(), numbers.end(), [](float v) { return std::isnan(v); })) kind = DroppedKind::nan;
    dropped_.add({x, y, kind, value, weight});
}

template class BasicFilmTile<ExactSums>;
template class BasicFilmTile<DoubleSums>;
template class BasicFilmTile<FloatSums>;
template class BasicFilmTile<KahanFloatSums>;

}  // namespace emulsion
