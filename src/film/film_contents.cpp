#include "film/film_contents.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace emulsion {

namespace {

std::size_t pixel_count(const PixelBounds& bounds) noexcept {
    return static_cast<std::size_t>(bounds.width()) * static_cast<std::size_t>(bounds.height());
}

template <class Pixel>
bool has_fewer_samples(const Pixel& a, const Pixel& b) noexcept {
    return a.samples() < b.samples();
}

}  // namespace

template <class Sums>
FilmContents<Sums> empty_contents(const FilmSetup& setup) {
    const std::size_t pixels = pixel_count(setup.bounds);
    return {std::vector<typename Sums::FilmPixel>(pixels), ChannelSums(setup.channels, pixels), {}};
}

template <class Sums>
void require_size(const FilmContents<Sums>& contents, const FilmOptions& options) {
    const FilmChannels expected(options);
    const std::size_t pixels = pixel_count(bounds_of(options));
    const std::size_t sums = pixels * static_cast<std::size_t>(expected.sums);
    const std::size_t squares = pixels * static_cast<std::size_t>(expected.squares);
    const ChannelSums& channels = contents.channels;
    const bool fits = contents.pixels.size() == pixels && channels.layout() == expected &&
                      channels.all_sums().size() == sums && channels.all_squares().size() == squares;
    if (fits) return;
    const auto described = [](std::size_t of_pixels, std::size_t of_sums, std::size_t of_squares) {
        return std::to_string(of_pixels) + " pixels with " + std::to_string(of_sums) + " further sums and " +
               std::to_string(of_squares) + " of squares";
    };
    throw std::invalid_argument(
        "film: contents of " +
        described(contents.pixels.size(), channels.all_sums().size(), channels.all_squares().size()) + ", expected " +
        described(pixels, sums, squares));
}

void require_light_paths(const FilmCounts& counts) {
    if (counts.light_splats == 0 || counts.light_paths > 0) return;
    throw std::logic_error("film: it has " + std::to_string(counts.light_splats) +
                           " light splats, and nobody told it the number of light paths");
}

template <class Sums>
void merge(FilmContents<Sums>& contents, const FilmContents<Sums>& other) noexcept {
    for (std::size_t i = 0; i < contents.pixels.size(); ++i) contents.pixels[i].merge(other.pixels[i]);
    contents.channels.add(0, other.channels, 0, contents.pixels.size());
    contents.counts.merge(other.counts);
}

template <class Sums>
Image<XYZ> xyz_image(const FilmContents<Sums>& contents, const FilmSetup& setup) {
    const FilmCounts& counts = contents.counts;
    require_light_paths(counts);
    Image<XYZ> image(setup.bounds.width(), setup.bounds.height());
    for (std::size_t i = 0; i < contents.pixels.size(); ++i) {
        const PixelSums sums = sums_of(contents, i);
        const XYZd value =
            camera_value_of(sums, setup).value_or(XYZd{}) + light_value_of(sums, setup, counts.light_paths);
        image.pixels()[i] = {static_cast<float>(value.x), static_cast<float>(value.y), static_cast<float>(value.z)};
    }
    return image;
}

template <class Sums>
std::int64_t pixels_without_value(const FilmContents<Sums>& contents) {
    if (contents.counts.samples == 0 && contents.counts.light_paths > 0) return 0;
    std::int64_t count = 0;
    for (std::size_t i = 0; i < contents.pixels.size(); ++i) count += has_value(sums_of(contents, i)) ? 0 : 1;
    return count;
}

template <class Sums>
std::int64_t saturated_pixels(const FilmContents<Sums>& contents) {
    std::int64_t count = 0;
    for (std::size_t i = 0; i < contents.pixels.size(); ++i) {
        count += contents.pixels[i].is_saturated() || contents.channels.is_saturated(i) ? 1 : 0;
    }
    return count;
}

template <class Sums>
std::uint64_t min_samples_per_pixel(const FilmContents<Sums>& contents) {
    const auto& pixels = contents.pixels;
    return std::min_element(pixels.begin(), pixels.end(), has_fewer_samples<typename Sums::FilmPixel>)->samples();
}

template <class Sums>
std::uint64_t max_samples_per_pixel(const FilmContents<Sums>& contents) {
    const auto& pixels = contents.pixels;
    return std::max_element(pixels.begin(), pixels.end(), has_fewer_samples<typename Sums::FilmPixel>)->samples();
}

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): a list of instantiations
#define EMULSION_INSTANTIATE(Sums)                                                \
    template FilmContents<Sums> empty_contents(const FilmSetup&);                 \
    template void require_size(const FilmContents<Sums>&, const FilmOptions&);    \
    template void merge(FilmContents<Sums>&, const FilmContents<Sums>&) noexcept; \
    template Image<XYZ> xyz_image(const FilmContents<Sums>&, const FilmSetup&);   \
    template std::int64_t pixels_without_value(const FilmContents<Sums>&);        \
    template std::int64_t saturated_pixels(const FilmContents<Sums>&);            \
    template std::uint64_t min_samples_per_pixel(const FilmContents<Sums>&);      \
    template std::uint64_t max_samples_per_pixel(const FilmContents<Sums>&)
EMULSION_INSTANTIATE(ExactSums);
EMULSION_INSTANTIATE(DoubleSums);
EMULSION_INSTANTIATE(FloatSums);
EMULSION_INSTANTIATE(KahanFloatSums);
#undef EMULSION_INSTANTIATE

}  // namespace emulsion
