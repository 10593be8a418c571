#include "film/film.h"

#include <algorithm>
#include <cstddef>
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

bool has_value(const WeightedSums& sums, std::uint32_t samples) noexcept {
    return sums.weight > 0.0 && sums.weight >= kMinMeanWeight * static_cast<double>(samples);
}

template <class Pixel>
bool has_fewer_samples(const Pixel& a, const Pixel& b) noexcept {
    return a.samples() < b.samples();
}

}  // namespace

void validate(const FilmOptions& options) {
    require_size("width_px", options.width_px);
    require_size("height_px", options.height_px);
    validate(options.sensor);
}

template <class Sums>
BasicFilm<Sums>::BasicFilm(const FilmOptions& options) : options_(options) {
    validate(options);
    sensor_ = std::make_shared<const Sensor>(options.sensor);
    pixels_.resize(static_cast<std::size_t>(options.width_px) * static_cast<std::size_t>(options.height_px));
}

template <class Sums>
BasicFilmTile<Sums> BasicFilm<Sums>::make_tile(PixelBounds tile_bounds) const {
    require_inside(tile_bounds, bounds());
    return {tile_bounds, sensor_};
}

template <class Sums>
void BasicFilm<Sums>::merge(const BasicFilmTile<Sums>& tile) {
    const PixelBounds& inside = tile.bounds();
    require_inside(inside, bounds());
    const auto tile_width = static_cast<std::size_t>(inside.width());
    const auto film_width = static_cast<std::size_t>(options_.width_px);

    const std::lock_guard lock(mutex_);
    std::size_t from = 0;
    for (int y = inside.y0; y < inside.y1; ++y) {
        std::size_t to = static_cast<std::size_t>(y) * film_width + static_cast<std::size_t>(inside.x0);
        for (const std::size_t end = from + tile_width; from < end; ++from, ++to) {
            const std::uint32_t count = tile.sample_counts()[from];
            pixels_[to].add(tile.pixels()[from], count < tile.kMostSamples ? count : SampleCount::kMost);
        }
    }
    dropped_.merge(tile.dropped());
}

template <class Sums>
Image<XYZ> BasicFilm<Sums>::xyz_image() const {
    Image<XYZ> image(options_.width_px, options_.height_px);
    const std::lock_guard lock(mutex_);
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        const WeightedSums sums = pixels_[i].sums();
        if (!has_value(sums, pixels_[i].samples())) continue;
        image.pixels()[i] = {static_cast<float>(sums.xyz.x / sums.weight), static_cast<float>(sums.xyz.y / sums.weight),
                             static_cast<float>(sums.xyz.z / sums.weight)};
    }
    return image;
}

template <class Sums>
std::int64_t BasicFilm<Sums>::pixels_without_value() const {
    const std::lock_guard lock(mutex_);
    return std::count_if(pixels_.begin(), pixels_.end(),
                         [](const Pixel& pixel) { return !has_value(pixel.sums(), pixel.samples()); });
}

template <class Sums>
std::int64_t BasicFilm<Sums>::saturated_pixels() const {
    const std::lock_guard lock(mutex_);
    return std::count_if(pixels_.begin(), pixels_.end(), [](const Pixel& pixel) { return pixel.is_saturated(); });
}

template <class Sums>
DroppedSamples BasicFilm<Sums>::dropped() const {
    const std::lock_guard lock(mutex_);
    return dropped_;
}

template <class Sums>
std::uint64_t BasicFilm<Sums>::sample_count() const {
    const std::lock_guard lock(mutex_);
    return std::accumulate(pixels_.begin(), pixels_.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const Pixel& pixel) { return sum + pixel.samples(); });
}

template <class Sums>
std::uint64_t BasicFilm<Sums>::min_samples_per_pixel() const {
    const std::lock_guard lock(mutex_);
    return std::min_element(pixels_.begin(), pixels_.end(), has_fewer_samples<Pixel>)->samples();
}

template <class Sums>
std::uint64_t BasicFilm<Sums>::max_samples_per_pixel() const {
    const std::lock_guard lock(mutex_);
    return std::max_element(pixels_.begin(), pixels_.end(), has_fewer_samples<Pixel>)->samples();
}

template class BasicFilm<ExactSums>;
template class BasicFilm<DoubleSums>;
template class BasicFilm<FloatSums>;
template class BasicFilm<KahanFloatSums>;

}  // namespace emulsion
