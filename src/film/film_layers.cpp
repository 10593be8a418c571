#include "film/film_layers.h"

#include <array>
#include <cstddef>
#include <string>
#include <utility>

namespace emulsion {

namespace {

/// Of each pixel, value(sums).
template <class T, class Value>
Image<T> image_of(const FilmContents<ExactSums>& contents, const FilmSetup& setup, const Value& value) {
    Image<T> image(setup.bounds.width(), setup.bounds.height());
    for (std::size_t i = 0; i < contents.pixels.size(); ++i) {
        image.pixels()[i] = static_cast<T>(value(sums_of(contents, i)));
    }
    return image;
}

void add_variances(const FilmContents<ExactSums>& contents, const FilmSetup& setup, FilmPicture& picture) {
    constexpr std::array<std::pair<const char*, double XYZd::*>, 3> kComponents = {
        {{".X", &XYZd::x}, {".Y", &XYZd::y}, {".Z", &XYZd::z}}};
    for (const auto& [suffix, component] : kComponents) {
        if (setup.options.variance == FilmVariance::luminance && component != &XYZd::y) continue;
        const auto layer = [&, component = component](XYZd PixelVariance::*quantity) {
            return image_of<float>(
                contents, setup, [&](const PixelSums& sums) { return variance_of(sums, setup).*quantity.*component; });
        };
        picture.floats.push_back({std::string("variance") + suffix, layer(&PixelVariance::variance)});
        picture.floats.push_back({std::string("standard-error") + suffix, layer(&PixelVariance::standard_error)});
    }
}

void add_spectrum(const FilmContents<ExactSums>& contents, const FilmSetup& setup, FilmPicture& picture) {
    const SpectralBuckets& buckets = *setup.options.spectrum;
    for (int bucket = 0; bucket < buckets.count; ++bucket) {
        picture.spectral.push_back(
            {buckets.centre_nm(bucket), buckets.width_nm(),
             image_of<float>(contents, setup, [&](const PixelSums& sums) {
                 return bucket_radiance_of(sums, setup, bucket, contents.counts.light_paths).value_or(0.0);
             })});
    }
}

void add_aux(const FilmContents<ExactSums>& contents, const FilmSetup& setup, FilmPicture& picture) {
    for (std::size_t layer = 0; layer < setup.options.aux.size(); ++layer) {
        const AuxLayer& named = setup.options.aux[layer];
        for (std::size_t component = 0; component < named.components.size(); ++component) {
            picture.floats.push_back({named.name + "." + named.components[component],
                                      image_of<float>(contents, setup, [&](const PixelSums& sums) {
                                          return aux_value_of(sums, setup, layer, component);
                                      })});
        }
    }
}

}  // namespace

FilmPicture picture_of(const FilmContents<ExactSums>& contents, const FilmSetup& setup) {
    const FilmOptions& options = setup.options;
    FilmPicture picture{.xyz = xyz_image(contents, setup),
                        .data_window = setup.bounds,
                        .width_px = options.width_px,
                        .height_px = options.height_px};
    if (options.variance != FilmVariance::none) add_variances(contents, setup, picture);
    if (options.spectrum) add_spectrum(contents, setup, picture);
    if (!options.aux.empty()) add_aux(contents, setup, picture);
    if (picture.floats.empty() && picture.spectral.empty()) return picture;
    picture.counts.push_back(
        {"samples", image_of<std::uint32_t>(contents, setup, [](const PixelSums& sums) { return sums.samples; })});
    return picture;
}

FilmPicture picture_of(const Film& film) {
    return film.with_contents(
        [&](const FilmContents<ExactSums>& contents) { return picture_of(contents, film.setup()); });
}

}  // namespace emulsion
