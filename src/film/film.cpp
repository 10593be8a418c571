#include "film/film.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace emulsion {

namespace {

void require_inside(const PixelBounds& places, const PixelBounds& film) {
    if (film.contains(places)) return;
    throw std::invalid_argument("film tile: bounds are " + to_string(places) + ", expected pixels inside " +
                                to_string(film));
}

std::size_t pixel_count(const PixelBounds& bounds) noexcept {
    return static_cast<std::size_t>(bounds.width()) * static_cast<std::size_t>(bounds.height());
}

template <class Sums>
void require_size(const FilmContents<Sums>& contents, const FilmSetup& setup) {
    const std::size_t pixels = pixel_count(setup.bounds);
    const std::size_t sums = pixels * static_cast<std::size_t>(setup.channels.sums);
    const bool fits = contents.pixels.size() == pixels && contents.channels.layout() == setup.channels &&
                      contents.channels.all_sums().size() == sums;
    if (fits) return;
    throw std::invalid_argument("film: contents of " + std::to_string(contents.pixels.size()) + " pixels with " +
                                std::to_string(contents.channels.all_sums().size()) + " further sums, expected " +
                                std::to_string(pixels) + " with " + std::to_string(sums));
}

template <class Sums>
FilmContents<Sums> empty_contents(const FilmSetup& setup) {
    const std::size_t pixels = pixel_count(setup.bounds);
    return {std::vector<typename Sums::FilmPixel>(pixels), ChannelSums(setup.channels, pixels), {}};
}

template <class Pixel>
bool has_fewer_samples(const Pixel& a, const Pixel& b) noexcept {
    return a.samples() < b.samples();
}

}  // namespace

template <class Sums>
BasicFilm<Sums>::BasicFilm(const FilmOptions& options)
    : setup_(std::make_shared<const FilmSetup>(options)), contents_(empty_contents<Sums>(*setup_)) {}

template <class Sums>
BasicFilm<Sums>::BasicFilm(const FilmOptions& options, FilmContents<Sums> contents)
    : setup_(std::make_shared<const FilmSetup>(options)), contents_(std::move(contents)) {
    require_size(contents_, *setup_);
}

template <class Sums>
BasicFilmTile<Sums> BasicFilm<Sums>::make_tile(PixelBounds places) const {
    require_inside(places, sample_bounds());
    return {places, setup_};
}

template <class Sums>
void BasicFilm<Sums>::merge(const BasicFilmTile<Sums>& tile) {
    require_inside(tile.places(), sample_bounds());
    if (tile.channels().layout() != setup_->channels) {
        throw std::invalid_argument("film: a tile of a film with other options was to be merged");
    }
    FilmCounts counts;
    counts.samples = tile.sample_count();
    counts.light_splats = tile.light_splat_count();
    counts.dropped_aux = tile.dropped_aux();
    counts.dropped = tile.dropped();
    counts.clamped = tile.clamped();

    const PixelBounds& inside = tile.bounds();
    const auto tile_width = static_cast<std::size_t>(std::max(inside.width(), 0));
    const auto film_width = static_cast<std::size_t>(bounds().width());
    const std::lock_guard lock(mutex_);
    std::size_t from = 0;
    for (int y = inside.y0; y < inside.y1; ++y) {
        std::size_t to =
            static_cast<std::size_t>(y - bounds().y0) * film_width + static_cast<std::size_t>(inside.x0 - bounds().x0);
        contents_.channels.add(to, tile.channels(), from, tile_width);
        for (const std::size_t end = from + tile_width; from < end; ++from, ++to) {
            const auto& pixel = tile.pixels()[from];
            const std::uint64_t count = pixel.samples();
            contents_.pixels[to].add(
                pixel, count < tile.kMostSamples ? static_cast<std::uint32_t>(count) : SampleCount::kMost);
        }
    }
    contents_.counts.merge(counts);
}

template <class Sums>
void BasicFilm<Sums>::merge(const BasicFilm& other) {
    if (&other == this) throw std::invalid_argument("film: it was to be merged into itself");
    if (other.options() != options()) {
        throw std::invalid_argument("film: one with other options was to be merged: " + to_text(other.options()) +
                                    ", expected " + to_text(options()));
    }
    const std::scoped_lock lock(mutex_, other.mutex_);
    for (std::size_t i = 0; i < contents_.pixels.size(); ++i) contents_.pixels[i].merge(other.contents_.pixels[i]);
    contents_.channels.add(0, other.contents_.channels, 0, contents_.pixels.size());
    contents_.counts.merge(other.contents_.counts);
}

template <class Sums>
void BasicFilm<Sums>::add_light_paths(std::uint64_t paths) {
    const std::lock_guard lock(mutex_);
    contents_.counts.light_paths += paths;
}

template <class Sums>
Image<XYZ> BasicFilm<Sums>::xyz_image() const {
    Image<XYZ> image(bounds().width(), bounds().height());
    const std::lock_guard lock(mutex_);
    const FilmCounts& counts = contents_.counts;
    if (counts.light_splats > 0 && counts.light_paths == 0) {
        throw std::logic_error("film: it has " + std::to_string(counts.light_splats) +
                               " light splats, and nobody told it the number of light paths");
    }
    for (std::size_t i = 0; i < contents_.pixels.size(); ++i) {
        const PixelSums sums = pixel_sums(i);
        const XYZd value =
            camera_value_of(sums, *setup_).value_or(XYZd{}) + light_value_of(sums, *setup_, counts.light_paths);
        image.pixels()[i] = {static_cast<float>(value.x), static_cast<float>(value.y), static_cast<float>(value.z)};
    }
    return image;
}

template <class Sums>
std::int64_t BasicFilm<Sums>::pixels_without_value() const {
    const std::lock_guard lock(mutex_);
    if (contents_.counts.samples == 0 && contents_.counts.light_paths > 0) return 0;
    std::int64_t count = 0;
    for (std::size_t i = 0; i < contents_.pixels.size(); ++i) count += has_value(pixel_sums(i)) ? 0 : 1;
    return count;
}

template <class Sums>
std::int64_t BasicFilm<Sums>::saturated_pixels() const {
    const std::lock_guard lock(mutex_);
    std::int64_t count = 0;
    for (std::size_t i = 0; i < contents_.pixels.size(); ++i) {
        count += contents_.pixels[i].is_saturated() || contents_.channels.is_saturated(i) ? 1 : 0;
    }
    return count;
}

template <class Sums>
FilmCounts BasicFilm<Sums>::counts() const {
    const std::lock_guard lock(mutex_);
    return contents_.counts;
}

template <class Sums>
std::uint64_t BasicFilm<Sums>::min_samples_per_pixel() const {
    const std::lock_guard lock(mutex_);
    return std::min_element(contents_.pixels.begin(), contents_.pixels.end(), has_fewer_samples<Pixel>)->samples();
}

template <class Sums>
std::uint64_t BasicFilm<Sums>::max_samples_per_pixel() const {
    const std::lock_guard lock(mutex_);
    return std::max_element(contents_.pixels.begin(), contents_.pixels.end(), has_fewer_samples<Pixel>)->samples();
}

template <class Sums>
FilmContents<Sums> BasicFilm<Sums>::contents() const {
    const std::lock_guard lock(mutex_);
    return contents_;
}

template class BasicFilm<ExactSums>;
template class BasicFilm<DoubleSums>;
template class BasicFilm<FloatSums>;
template class BasicFilm<KahanFloatSums>;

}  // namespace emulsion
