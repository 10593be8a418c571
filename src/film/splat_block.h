#pragma once
// What a splat touches: the pixels of a tile that the film's filter reaches from a place, and their weights along both
// axes.

#include <cstddef>
#include <span>
#include <vector>

#include "core/color.h"
#include "core/image.h"
#include "film/exact_tile_pixel.h"
#include "film/filter_footprint.h"

namespace emulsion {

/// Columns times rows of pixels. Its weights lie in the WeightRoom that it was made with.
struct SplatBlock {
    std::size_t first = 0;      ///< among the tile's pixels, row by row
    std::ptrdiff_t stride = 0;  ///< from row to row
    std::span<const float> x_weights = {}, y_weights = {};

    [[nodiscard]] std::size_t size() const noexcept { return x_weights.size() * y_weights.size(); }
};

/// Where the weights of one splat are put.
struct WeightRoom {
    std::vector<float> x, y;

    WeightRoom() = default;
    explicit WeightRoom(const FilterFootprint& footprint)
        : x(footprint.room(FilterAxis::x)), y(footprint.room(FilterAxis::y)) {}
};

/// Those of the pixels in `bounds`; none, perhaps.
[[nodiscard]] SplatBlock block_reached(const FilterFootprint& footprint, const PixelBounds& bounds, float x_px,
                                       float y_px, WeightRoom& room) noexcept;

/// Calls visit(pixel, weight) for each of them.
template <class Visit>
void for_each_pixel(const SplatBlock& block, const Visit& visit) noexcept {
    std::size_t first = block.first;
    for (const float y_weight : block.y_weights) {
        std::size_t i = first;
        for (const float x_weight : block.x_weights) visit(i++, x_weight * y_weight);
        first += static_cast<std::size_t>(block.stride);
    }
}

/// Adds XYZ to each of them by its weight: pixels.add(x, y, z, weight), pixel by pixel.
template <class Pixel>
void add_block(std::span<Pixel> pixels, const SplatBlock& block, const XYZd& xyz) noexcept {
    for_each_pixel(
        block, [&](std::size_t i, float weight) { pixels[i].add(xyz.x, xyz.y, xyz.z, static_cast<double>(weight)); });
}
inline void add_block(std::span<ExactTilePixel> pixels, const SplatBlock& block, const XYZd& xyz) noexcept {
    ExactTilePixel::add_block(pixels.data() + block.first, block.stride, block.x_weights, block.y_weights, xyz);
}

}  // namespace emulsion
