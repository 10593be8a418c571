#pragma once
// Where callers of the C interface want pixels to go.

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>

#include "capi/status.h"
#include "film/film.h"

namespace emulsion::capi {

/// `per_pixel` numbers for each pixel of the film.
/// \throws std::invalid_argument naming the array if it is NULL or has another length.
template <class T>
std::span<T> pixel_numbers(T* numbers, std::size_t length, const Film& film, std::size_t per_pixel, const char* name) {
    const PixelBounds bounds = film.bounds();
    const std::size_t expected =
        per_pixel * static_cast<std::size_t>(bounds.width()) * static_cast<std::size_t>(bounds.height());
    dereference(numbers, name);
    if (length == expected) return {numbers, length};
    throw std::invalid_argument(std::string(name) + " has " + std::to_string(length) + " numbers, expected " +
                                std::to_string(expected));
}

}  // namespace emulsion::capi
