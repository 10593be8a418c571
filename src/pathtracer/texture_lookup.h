#pragma once
// Values of images between and beyond their texels. (s, t) = (0, 1) is the left top corner of the image, as rows count
// from the top and t from the bottom.
//
// pbrt-v4 filters images by the footprint of the ray, with a pyramid of levels (trilinear) or an ellipse on it (EWA);
// its bilinear filter, the default, takes the one level that suits the footprint. We have no ray differentials and one
// level: a picture converges to the same mean over its pixels, as texels of a level are means of those below, with more
// noise where texels are smaller than pixels. What its ellipses come to as footprints vanish, a bell, is done.

#include <algorithm>
#include <cmath>

#include <Imath/ImathVec.h>

#include "pathtracer/scene_texture.h"

namespace emulsion {

/// Column or row number i of an image of `size`, brought inside; -1: outside, where it is black.
[[nodiscard]] inline int wrapped_index(TextureWrap wrap, int i, int size) noexcept {
    if (i >= 0 && i < size) return i;
    if (wrap == TextureWrap::black) return -1;
    if (wrap == TextureWrap::clamp) return std::clamp(i, 0, size - 1);
    const int rest = i % size;
    return rest < 0 ? rest + size : rest;
}

/// Texel (x, y) of an image that goes on beyond its borders as `wrap` says: at most by its own size, and by one texel
/// under octahedral_sphere. That is mirrored as pbrt-v4 does it, which goes to the second column instead of the first
/// at the left and at the top.
template <class Texel>
[[nodiscard]] Texel wrapped_texel(const Image<Texel>& image, TextureWrap wrap, int x, int y) noexcept {
    const int width = image.width(), height = image.height();
    if (wrap == TextureWrap::octahedral_sphere) {
        if (x < 0 || x >= width) {
            x = x < 0 ? -x : 2 * width - 1 - x;
            y = height - 1 - y;
        }
        if (y < 0 || y >= height) {
            x = width - 1 - x;
            y = y < 0 ? -y : 2 * height - 1 - y;
        }
        return image(std::clamp(x, 0, width - 1), std::clamp(y, 0, height - 1));
    }
    x = wrapped_index(wrap, x, width);
    y = wrapped_index(wrap, y, height);
    return x < 0 || y < 0 ? Texel{} : image(x, y);
}

/// The coordinate brought near [0, 1], so that numbers of texels fit an int; NaN to 0.
[[nodiscard]] inline double reduced_coordinate(TextureWrap wrap, double s) noexcept {
    switch (wrap) {
        case TextureWrap::repeat: {
            const double part = s - std::floor(s);
            return part > 0.0 ? std::min(part, 1.0) : 0.0;
        }
        case TextureWrap::octahedral_sphere:
            return s > 0.0 ? std::min(s, 1.0) : 0.0;
        default:
            // One size beyond, where nothing changes any more.
            return s > -1.0 ? std::min(s, 2.0) : (s <= -1.0 ? -1.0 : 0.0);
    }
}

/// Of four texels, with the sum 1.
struct TexelWeights {
    float left_top, right_top, left_bottom, right_bottom;
};
[[nodiscard]] inline TexelWeights gaussian_weights(float across, float down) noexcept {
    constexpr float kEnd = 0.135335283f;  // exp(-2)
    const auto bell = [](float x, float y) {
        const float r2 = x * x + y * y;
        return r2 < 1.0f ? std::exp(-2.0f * r2) - kEnd : 0.0f;
    };
    const TexelWeights w = {bell(across, down), bell(1.0f - across, down), bell(across, 1.0f - down),
                            bell(1.0f - across, 1.0f - down)};
    const float scale = 1.0f / (w.left_top + w.right_top + w.left_bottom + w.right_bottom);
    return {w.left_top * scale, w.right_top * scale, w.left_bottom * scale, w.right_bottom * scale};
}

/// The image's value at (s, t), any numbers.
template <class Texel>
[[nodiscard]] Texel lookup(const Image<Texel>& image, TextureWrap wrap, TextureFilter filter,
                           const Imath::V2d& st) noexcept {
    const double x = reduced_coordinate(wrap, st.x) * static_cast<double>(image.width());
    const double y = reduced_coordinate(wrap, 1.0 - st.y) * static_cast<double>(image.height());
    if (filter == TextureFilter::nearest) {
        return wrapped_texel(image, wrap, static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)));
    }
    const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
    const auto across = static_cast<float>(x - 0.5 - left), down = static_cast<float>(y - 0.5 - top);
    const int column = static_cast<int>(left), row = static_cast<int>(top);
    if (filter == TextureFilter::gaussian) {
        const TexelWeights w = gaussian_weights(across, down);
        return w.left_top * wrapped_texel(image, wrap, column, row) +
               w.right_top * wrapped_texel(image, wrap, column + 1, row) +
               w.left_bottom * wrapped_texel(image, wrap, column, row + 1) +
               w.right_bottom * wrapped_texel(image, wrap, column + 1, row + 1);
    }
    const auto between = [](const Texel& a, const Texel& b, float part) { return (1.0f - part) * a + part * b; };
    return between(
        between(wrapped_texel(image, wrap, column, row), wrapped_texel(image, wrap, column + 1, row), across),
        between(wrapped_texel(image, wrap, column, row + 1), wrapped_texel(image, wrap, column + 1, row + 1), across),
        down);
}

}  // namespace emulsion
