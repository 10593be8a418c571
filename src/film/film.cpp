#include "film/film.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

namespace emulsion {

namespace {

void require_size(const char* field, int value) {
    constexpr int kLargest = 65536;
    if (value >= 1 && value <= kLargest) return;
    throw std::invalid_argument(std::string("film: ") + field + " is " + std::to_string(value) +
                                ", expected a number in [1, " + std::to_string(kLargest) + "]");
}

std::string to_string(const PixelBounds& bounds) {
    return "[" + std::to_string(bounds.x0) + ", " + std::to_string(bounds.x1) + ") x [" + std::to_string(bounds.y0) +
           ", " + std::to_string(bounds.y1) + ")";
}

void require_inside(const PixelBounds& bounds, const PixelBounds& film) {
    const bool inside = film.x0 <= bounds.x0 && bounds.x0 < bounds.x1 && bounds.x1 <= film.x1 &&  //
                        film.y0 <= bounds.y0 && bounds.y0 < bounds.y1 && bounds.y1 <= film.y1;
    if (inside) return;
    throw std::invalid_argument("film tile: bounds are " + to_string(bounds) + ", expected pixels inside " +
                                to_string(film));
}

}  // namespace

void validate(const FilmOptions& options) {
    require_size("width_px", options.width_px);
    require_size("height_px", options.height_px);
    validate(options.sensor);
}

Film::Film(const FilmOptions& options) : options_(options) {
    validate(options);
    sensor_ = std::make_shared<const Sensor>(options.sensor);
    const std::size_t count = static_cast<std::size_t>(options.width_px) * static_cast<std::size_t>(options.height_px);
    pixels_.resize(count);
    sample_counts_.resize(count);
}

FilmTile Film::make_tile(PixelBounds tile_bounds) const {
    require_inside(tile_bounds, bounds());
    return {tile_bounds, sensor_};
}

void Film::merge(const FilmTile& tile) {
    const PixelBounds& inside = tile.bounds();
    require_inside(inside, bounds());
    const auto tile_width = static_cast<std::size_t>(inside.width());
    const auto film_width = static_cast<std::size_t>(options_.width_px);

    const std::lock_guard lock(mutex_);
    std::size_t from = 0;
    for (int y = inside.y0; y < inside.y1; ++y) {
        std::size_t to = static_cast<std::size_t>(y) * film_width + static_cast<std::size_t>(inside.x0);
        for (const std::size_t end = from + tile_width; from < end; ++from, ++to) {
            const TilePixel& sums = tile.pixels()[from];
            Pixel& pixel = pixels_[to];
            pixel.x += ExactSum(sums.x);
            pixel.y += ExactSum(sums.y);
            pixel.z += ExactSum(sums.z);
            pixel.weight += ExactSum(sums.weight);
            sample_counts_[to] += tile.sample_counts()[from];
        }
    }
    dropped_.merge(tile.dropped());
}

bool Film::has_value(std::size_t i) const noexcept {
    const double weight = pixels_[i].weight.value();
    return weight > 0.0 && weight >= kMinMeanWeight * static_cast<double>(sample_counts_[i]);
}

Image<XYZ> Film::xyz_image() const {
    Image<XYZ> image(options_.width_px, options_.height_px);
    const std::lock_guard lock(mutex_);
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        if (!has_value(i)) continue;
        const Pixel& pixel = pixels_[i];
        const double weight = pixel.weight.value();
        image.pixels()[i] = {static_cast<float>(pixel.x.value() / weight), static_cast<float>(pixel.y.value() / weight),
                             static_cast<float>(pixel.z.value() / weight)};
    }
    return image;
}

std::int64_t Film::pixels_without_value() const {
    const std::lock_guard lock(mutex_);
    std::int64_t count = 0;
    for (std::size_t i = 0; i < pixels_.size(); ++i) count += has_value(i) ? 0 : 1;
    return count;
}

std::int64_t Film::saturated_pixels() const {
    const std::lock_guard lock(mutex_);
    return std::count_if(pixels_.begin(), pixels_.end(), [](const Pixel& pixel) {
        return pixel.x.is_saturated() || pixel.y.is_saturated() || pixel.z.is_saturated() ||
               pixel.weight.is_saturated();
    });
}

DroppedSamples Film::dropped() const {
    const std::lock_guard lock(mutex_);
    return dropped_;
}

std::uint64_t Film::sample_count() const {
    const std::lock_guard lock(mutex_);
    return std::accumulate(sample_counts_.begin(), sample_counts_.end(), std::uint64_t{0});
}

std::uint64_t Film::min_samples_per_pixel() const {
    const std::lock_guard lock(mutex_);
    return *std::min_element(sample_counts_.begin(), sample_counts_.end());
}

std::uint64_t Film::max_samples_per_pixel() const {
    const std::lock_guard lock(mutex_);
    return *std::max_element(sample_counts_.begin(), sample_counts_.end());
}

}  // namespace emulsion
