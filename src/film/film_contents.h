#pragma once
// Everything that a film has gathered, as it lies in memory, and what follows from it.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/color.h"
#include "core/image.h"
#include "film/film_channels.h"
#include "film/film_counts.h"
#include "film/film_setup.h"
#include "film/film_sums.h"
#include "film/pixel_values.h"

namespace emulsion {

/// Plain integers, if the sums are exact: those of two films of the same options may be added one by one, by anybody.
template <class Sums>
struct FilmContents {
    std::vector<typename Sums::FilmPixel> pixels;  ///< of the film's bounds, row by row
    ChannelSums channels;                          ///< of the same pixels
    FilmCounts counts;
    bool operator==(const FilmContents&) const = default;
};

/// Of a film without samples.
template <class Sums>
[[nodiscard]] FilmContents<Sums> empty_contents(const FilmSetup& setup);

/// \throws std::invalid_argument unless they have the pixels and the sums of such a film.
template <class Sums>
void require_size(const FilmContents<Sums>& contents, const FilmOptions& options);

/// \throws std::logic_error if there are light splats and the number of light paths is 0.
void require_light_paths(const FilmCounts& counts);

/// Adds what another film of the same options has gathered; both must have its size.
template <class Sums>
void merge(FilmContents<Sums>& contents, const FilmContents<Sums>& other) noexcept;

/// The sums of pixel i.
template <class Sums>
[[nodiscard]] PixelSums sums_of(const FilmContents<Sums>& contents, std::size_t i) noexcept {
    const auto& pixel = contents.pixels[i];
    return {pixel.sums(), pixel.samples(), contents.channels.sums(i), contents.channels.squares(i)};
}

// As the members of BasicFilm of the same names say.
template <class Sums>
[[nodiscard]] Image<XYZ> xyz_image(const FilmContents<Sums>& contents, const FilmSetup& setup);
template <class Sums>
[[nodiscard]] std::int64_t pixels_without_value(const FilmContents<Sums>& contents);
template <class Sums>
[[nodiscard]] std::int64_t saturated_pixels(const FilmContents<Sums>& contents);
template <class Sums>
[[nodiscard]] std::uint64_t min_samples_per_pixel(const FilmContents<Sums>& contents);
template <class Sums>
[[nodiscard]] std::uint64_t max_samples_per_pixel(const FilmContents<Sums>& contents);

}  // namespace emulsion
