#include "film/film_tile.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace emulsion {

FilmTile::FilmTile(PixelBounds bounds, std::shared_ptr<const Sensor> sensor)
    : bounds_(bounds), sensor_(std::move(sensor)) {
    if (bounds.width() < 1 || bounds.height() < 1) {
        throw std::invalid_argument("film tile of " + std::to_string(bounds.width()) + "x" +
                                    std::to_string(bounds.height()) + " pixels: both must be at least 1");
    }
    if (!sensor_) throw std::invalid_argument("film tile: sensor is missing");
    const std::size_t count = static_cast<std::size_t>(bounds.width()) * static_cast<std::size_t>(bounds.height());
    pixels_.resize(count);
    sample_counts_.resize(count);
}

void FilmTile::clear() noexcept {
    std::fill(pixels_.begin(), pixels_.end(), TilePixel{});
    std::fill(sample_counts_.begin(), sample_counts_.end(), 0u);
    dropped_ = {};
}

void FilmTile::drop(int x, int y, XYZ value, float weight) noexcept {
    DroppedKind kind = DroppedKind::negative_luminance;
    const std::array<float, 4> numbers = {value.x, value.y, value.z, weight};
    if (std::any_of(numbers.begin(), numbers.end(), [](float v) { return std::isinf(v); })) {
        kind = DroppedKind::infinite;
    }
    if (std::any_of(numbers.begin(), numbers.end(), [](float v) { return std::isnan(v); })) kind = DroppedKind::nan;
    dropped_.add({x, y, kind, value, weight});
}

}  // namespace emulsion
