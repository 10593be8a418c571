// The C interface: tiles, and batches of samples.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>

#include "capi/emulsion.h"
#include "capi/handles.h"
#include "capi/status.h"
#include "core/color.h"
#include "core/image.h"
#include "core/matrix3.h"
#include "film/sample_batch.h"
#include "spectrum/rgb_space.h"

static_assert(EMULSION_MAX_WAVELENGTHS == emulsion::kMostBatchWavelengths);

namespace {

using emulsion::XYZ;
using emulsion::capi::dereference;
using emulsion::capi::guarded;

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

emulsion::BatchPixels pixels(std::size_t count, const std::int32_t* x_px, const std::int32_t* y_px,
                             const float* weight) {
    emulsion::BatchPixels to{array(x_px, count, 1, "x_px"), array(y_px, count, 1, "y_px"), {}};
    if (weight != nullptr) to.weight = array(weight, count, 1, "weight");
    return to;
}

}  // namespace

emulsion_status emulsion_tile_create(const emulsion_film* film, emulsion_rect bounds, emulsion_tile** tile) {
    return guarded([&] {
        emulsion_tile*& to = dereference(tile, "tile");
        const emulsion::Film& of = dereference(film, "film").film;
        to = new emulsion_tile{of.make_tile({bounds.x0, bounds.y0, bounds.x1, bounds.y1}), of.sensor().imaging_ratio()};
    });
}

emulsion_status emulsion_tile_destroy(emulsion_tile* tile) {
    delete tile;
    return EMULSION_OK;
}

emulsion_status emulsion_tile_clear(emulsion_tile* tile) {
    return guarded([&] { dereference(tile, "tile").tile.clear(); });
}

emulsion_status emulsion_tile_bounds(const emulsion_tile* tile, emulsion_rect* bounds) {
    return guarded([&] {
        const emulsion::PixelBounds& of_tile = dereference(tile, "tile").tile.bounds();
        dereference(bounds, "bounds") = {of_tile.x0, of_tile.y0, of_tile.x1, of_tile.y1};
    });
}

emulsion_status emulsion_tile_add_spectral(emulsion_tile* tile, size_t count, const int32_t* x_px, const int32_t* y_px,
                                           const float* weight, size_t wavelengths, const float* lambda_nm,
                                           const float* radiance, const float* pdf_per_nm) {
    return guarded([&] {
        const emulsion::BatchRadiance samples{wavelengths, array(lambda_nm, count, wavelengths, "lambda_nm"),
                                              array(radiance, count, wavelengths, "radiance"),
                                              array(pdf_per_nm, count, wavelengths, "pdf_per_nm")};
        add_batch(dereference(tile, "tile").tile, pixels(count, x_px, y_px, weight), samples);
    });
}

emulsion_status emulsion_tile_add_xyz(emulsion_tile* tile, size_t count, const int32_t* x_px, const int32_t* y_px,
                                      const float* weight, const float* xyz) {
    return guarded([&] {
        const std::span<const float> numbers = array(xyz, count, 3, "xyz");
        add_batch(dereference(tile, "tile").tile, pixels(count, x_px, y_px, weight), [numbers](std::size_t i) {
            return XYZ{numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
        });
    });
}

emulsion_status emulsion_tile_add_rgb(emulsion_tile* tile, size_t count, const int32_t* x_px, const int32_t* y_px,
                                      const float* weight, const char* space, const float* rgb) {
    return guarded([&] {
        const std::span<const float> numbers = array(rgb, count, 3, "rgb");
        emulsion_tile& to = dereference(tile, "tile");
        const emulsion::Matrix3 matrix = xyz_from_rgb(emulsion::rgb_space(&dereference(space, "space")));
        const double ratio = to.imaging_ratio;
        add_batch(to.tile, pixels(count, x_px, y_px, weight), [&](std::size_t i) {
            const auto number = [&](std::size_t k) { return ratio * static_cast<double>(numbers[3 * i + k]); };
            const auto xyz = matrix * std::array<double, 3>{number(0), number(1), number(2)};
            return XYZ{static_cast<float>(xyz[0]), static_cast<float>(xyz[1]), static_cast<float>(xyz[2])};
        });
    });
}
