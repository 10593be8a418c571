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

/// All options, those that to_text(FilmOptions) leaves out among them.
std::string described(const FilmOptions& options) {
    return to_string(bounds_of(options)) + " of " + std::to_string(options.width_px) + "x" +
           std::to_string(options.height_px) + " pixels, " + to_text(options.sensor) + " " + to_text(options);
}

/// `what`: "a film".
void require_same(const FilmOptions& found, const FilmOptions& expected, const char* what) {
    if (found == expected) return;
    throw std::invalid_argument(std::string("film: ") + what + " with other options was to be merged: " +
                                described(found) + ", expected " + described(expected));
}

}  // namespace

template <class Sums>
BasicFilm<Sums>::BasicFilm(const FilmOptions& options)
    : setup_(std::make_shared<const FilmSetup>(options)), contents_(empty_contents<Sums>(*setup_)) {}

template <class Sums>
BasicFilm<Sums>::BasicFilm(const FilmOptions& options, FilmContents<Sums> contents)
    : setup_(std::make_shared<const FilmSetup>(options)), contents_(std::move(contents)) {
    require_size(contents_, options);
}

template <class Sums>
BasicFilmTile<Sums> BasicFilm<Sums>::make_tile(PixelBounds places) const {
    require_inside(places, sample_bounds());
    return {places, setup_};
}

template <class Sums>
void BasicFilm<Sums>::merge(const BasicFilmTile<Sums>& tile) {
    if (&tile.setup() != setup_.get()) require_same(tile.setup().options, options(), "a tile of a film");
    require_inside(tile.places(), sample_bounds());
    FilmCounts counts;
    counts.samples = tile.sample_count();
    counts.light_splats = tile.light_splat_count();
    counts.dropped_aux = tile.dropped_aux();
    counts.faint = tile.faint_count();
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
    require_same(other.options(), options(), "a film");
    const std::scoped_lock lock(mutex_, other.mutex_);
    emulsion::merge(contents_, other.contents_);
}

template <class Sums>
void BasicFilm<Sums>::add_light_paths(std::uint64_t paths) {
    const std::lock_guard lock(mutex_);
    contents_.counts.add_light_paths(paths);
}

template <class Sums>
Image<XYZ> BasicFilm<Sums>::xyz_image() const {
    const std::lock_guard lock(mutex_);
    return emulsion::xyz_image(contents_, *setup_);
}

template <class Sums>
std::int64_t BasicFilm<Sums>::pixels_without_value() const {
    const std::lock_guard lock(mutex_);
    return emulsion::pixels_without_value(contents_);
}

template <class Sums>
std::int64_t BasicFilm<Sums>::saturated_pixels() const {
    const std::lock_guard lock(mutex_);
    return emulsion::saturated_pixels(contents_);
}

template <class Sums>
FilmCounts BasicFilm<Sums>::counts() const {
    const std::lock_guard lock(mutex_);
    return contents_.counts;
}

template <class Sums>
std::uint64_t BasicFilm<Sums>::min_samples_per_pixel() const {
    const std::lock_guard lock(mutex_);
    return emulsion::min_samples_per_pixel(contents_);
}

template <class Sums>
std::uint64_t BasicFilm<Sums>::max_samples_per_pixel() const {
    const std::lock_guard lock(mutex_);
    return emulsion::max_samples_per_pixel(contents_);
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
