#pragma once
// Pictures to sides of powers of two, as pbrt-v4 makes those that textures look up: the levels of its pyramids are half
// as large as the ones below. A texel of 100 x 60 pictures is so one of 128 x 64, and looks a little sharper.

#include "core/color.h"
#include "core/image.h"
#include "pathtracer/scene_texture.h"

namespace emulsion {

template <class Texel>
[[nodiscard]] bool has_sides_of_powers_of_two(const Image<Texel>& image) noexcept {
    const auto is_power = [](int side) { return (side & (side - 1)) == 0; };
    return is_power(image.width()) && is_power(image.height());
}

/// The smallest sides that are powers of two, each by itself. A texel is the mean of four in each direction, weighted
/// by sinc(x) sinc(x / 2) of their distance x, in texels of the picture, and goes beyond the values of its neighbours
/// at edges; what lies beyond the borders is as `wrap` says. Source: Duchon, "Lanczos Filtering in One and Two
/// Dimensions", J. Appl. Meteorol. 18, 1979.
[[nodiscard]] Image<RGB> enlarged_to_powers_of_two(const Image<RGB>& image, TextureWrap wrap);
[[nodiscard]] Image<float> enlarged_to_powers_of_two(const Image<float>& image, TextureWrap wrap);

}  // namespace emulsion
