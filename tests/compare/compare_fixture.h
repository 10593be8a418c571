#pragma once
// Pictures to compare.

#include <cmath>
#include <cstdint>
#include <utility>

#include "compare/compare.h"
#include "core/random.h"
#include "film/film.h"
#include "film/film_layers.h"
#include "spectrum/observer.h"
#include "spectrum/viewing_conditions.h"

namespace emulsion {

/// The full frame, nothing known of its noise.
inline ComparedPicture whole(Image<XYZ> xyz) {
    const int width = xyz.width(), height = xyz.height();
    ComparedPicture picture{.xyz = {}, .window = {0, 0, width, height}, .width_px = width, .height_px = height};
    picture.xyz = std::move(xyz);
    return picture;
}

inline XYZ narrowed(const XYZd& xyz) {
    return {static_cast<float>(xyz.x), static_cast<float>(xyz.y), static_cast<float>(xyz.z)};
}

/// All pixels the same.
inline ComparedPicture constant(const XYZd& xyz, int width = 7, int height = 5) {
    Image<XYZ> image(width, height);
    for (XYZ& pixel : image.pixels()) pixel = narrowed(xyz);
    return whole(std::move(image));
}

inline XYZd d65() { return default_white(cie_1931_2deg()); }

/// Colours at random, luminances over four decades.
inline ComparedPicture random_picture(int width, int height, std::uint64_t seed) {
    Pcg32 random(seed);
    Image<XYZ> image(width, height);
    for (XYZ& pixel : image.pixels()) {
        const auto luminance = static_cast<float>(std::pow(10.0, 4.0 * random.next_float() - 1.0));
        pixel = {luminance * (0.5f + random.next_float()), luminance, luminance * (0.2f + random.next_float())};
    }
    return whole(std::move(image));
}

/// A film of samples that are exponentially distributed about a grey of 30 cd/m^2 (variances 900), and of a bias.
inline ComparedPicture noisy_film(std::uint64_t seed, float bias, FilmVariance variance, int samples) {
    Film film({.width_px = 200, .height_px = 150, .variance = variance});
    FilmTile tile = film.make_tile(film.bounds());
    Pcg32 random(seed);
    const XYZ white = narrowed(d65());
    for (int y = 0; y < 150; ++y) {
        for (int x = 0; x < 200; ++x) {
            for (int i = 0; i < samples; ++i) {
                const float luminance = bias - 30.0f * std::log(1.0f - random.next_float());
                tile.add(x, y, luminance * white, 1.0f);
            }
        }
    }
    film.merge(tile);
    FilmImage image;
    static_cast<FilmPicture&>(image) = picture_of(film);
    return compared_picture(std::move(image));
}

}  // namespace emulsion
