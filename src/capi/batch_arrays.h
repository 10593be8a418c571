#pragma once
// From the arrays of the C interface to batches, and the tiles that take them.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>

#include "capi/handles.h"
#include "capi/status.h"
#include "film/film_options.h"
#include "film/sample_batch.h"

namespace emulsion::capi {

/// `count` samples of `per_sample` numbers each. \throws std::invalid_argument naming an array that is NULL.
template <class T>
std::span<const T> array(const T* numbers, std::size_t count, std::size_t per_sample, const char* name) {
    if (count == 0) return {};
    dereference(numbers, name);
    if (per_sample > std::numeric_limits<std::ptrdiff_t>::max() / sizeof(T) / count) {
        throw std::invalid_argument(std::string(name) + ": " + std::to_string(count) + " times " +
                                    std::to_string(per_sample) + " numbers, which is more than memory can hold");
    }
    return {numbers, count * per_sample};
}

inline BatchPixels pixels(std::size_t count, const std::int32_t* x_px, const std::int32_t* y_px, const float* weight) {
    BatchPixels to{array(x_px, count, 1, "x_px"), array(y_px, count, 1, "y_px"), {}};
    if (weight != nullptr) to.weight = array(weight, count, 1, "weight");
    return to;
}

inline BatchPlaces places(std::size_t count, const float* x_px, const float* y_px) {
    return {array(x_px, count, 1, "x_px"), array(y_px, count, 1, "y_px")};
}

/// The tile, if its film takes camera samples that way. \throws std::invalid_argument if it doesn't.
inline FilmTile& tile_for(emulsion_tile* tile, FilterUse use) {
    FilmTile& to = dereference(tile, "tile").tile;
    if (to.setup().options.filter_use == use) return to;
    throw std::invalid_argument(use == FilterUse::splatted
                                    ? "the film's filter_use is importance_sampled: its samples belong to pixels"
                                    : "the film's filter_use is splatted: its samples have places, not pixels");
}

}  // namespace emulsion::capi
