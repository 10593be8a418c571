// The C interface: what a film holds of its pixels beside their colour, as its options ask for it.

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>

#include "capi/emulsion.h"
#include "capi/handles.h"
#include "capi/pixel_numbers.h"
#include "capi/status.h"
#include "core/color.h"
#include "film/film.h"
#include "film/film_contents.h"
#include "film/pixel_values.h"

namespace {

using emulsion::Film;
using emulsion::FilmVariance;
using emulsion::PixelSums;
using emulsion::PixelVariance;
using emulsion::XYZd;
using emulsion::capi::dereference;
using emulsion::capi::guarded;
using emulsion::capi::pixel_numbers;

/// Of Y, or of X, Y and Z.
void read_errors(const Film& film, XYZd PixelVariance::*quantity, float* numbers, std::size_t length,
                 const char* name) {
    const FilmVariance variance = film.options().variance;
    if (variance == FilmVariance::none) throw std::invalid_argument("the film was made without variance");
    const std::size_t size = variance == FilmVariance::luminance ? 1 : 3;
    const std::span<float> to = pixel_numbers(numbers, length, film, size, name);
    film.for_each_pixel([&](std::size_t i, const PixelSums& sums) {
        const XYZd value = variance_of(sums, film.setup()).*quantity;
        if (size == 1) {
            to[i] = static_cast<float>(value.y);
            return;
        }
        to[3 * i] = static_cast<float>(value.x);
        to[3 * i + 1] = static_cast<float>(value.y);
        to[3 * i + 2] = static_cast<float>(value.z);
    });
}

}  // namespace

emulsion_status emulsion_film_read_sample_counts(const emulsion_film* film, uint32_t* counts, size_t length) {
    return guarded([&] {
        const Film& from = dereference(film, "film").film;
        const std::span<std::uint32_t> to = pixel_numbers(counts, length, from, 1, "counts");
        from.for_each_pixel([&](std::size_t i, const PixelSums& sums) { to[i] = sums.samples; });
    });
}

emulsion_status emulsion_film_read_variance(const emulsion_film* film, float* variance, size_t length) {
    return guarded(
        [&] { read_errors(dereference(film, "film").film, &PixelVariance::variance, variance, length, "variance"); });
}

emulsion_status emulsion_film_read_standard_error(const emulsion_film* film, float* standard_error, size_t length) {
    return guarded([&] {
        read_errors(dereference(film, "film").film, &PixelVariance::standard_error, standard_error, length,
                    "standard_error");
    });
}

emulsion_status emulsion_film_read_spectrum(const emulsion_film* film, float* radiance, size_t length) {
    return guarded([&] {
        const Film& from = dereference(film, "film").film;
        if (!from.options().spectrum) throw std::invalid_argument("the film was made without a spectrum");
        const int buckets = from.options().spectrum->count;
        const std::span<float> to =
            pixel_numbers(radiance, length, from, static_cast<std::size_t>(buckets), "radiance");
        from.with_contents([&](const emulsion::FilmContents<emulsion::ExactSums>& contents) {
            const std::uint64_t light_paths = contents.counts.light_paths;
            require_light_paths(contents.counts);
            auto number = to.begin();
            for (std::size_t i = 0; i < contents.pixels.size(); ++i) {
                const PixelSums sums = sums_of(contents, i);
                for (int bucket = 0; bucket < buckets; ++bucket) {
                    *number++ =
                        static_cast<float>(bucket_radiance_of(sums, from.setup(), bucket, light_paths).value_or(0.0));
                }
            }
        });
    });
}
