// The C interface: tiles, and batches of samples.

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>

#include "capi/batch_arrays.h"
#include "capi/emulsion.h"
#include "capi/handles.h"
#include "capi/status.h"
#include "core/color.h"
#include "core/image.h"
#include "film/film_options.h"
#include "film/rgb_input.h"
#include "film/sample_batch.h"
#include "spectrum/rgb_space.h"

static_assert(EMULSION_MAX_WAVELENGTHS == emulsion::kMostBatchWavelengths);

namespace {

using emulsion::XYZ;
using emulsion::capi::array;
using emulsion::capi::dereference;
using emulsion::capi::guarded;
using emulsion::capi::pixels;
using emulsion::capi::places;
using emulsion::capi::tile_for;

emulsion::BatchRadiance spectra(std::size_t count, std::size_t wavelengths, const float* lambda_nm,
                                const float* radiance, const float* pdf_per_nm) {
    return {wavelengths, array(lambda_nm, count, wavelengths, "lambda_nm"),
            array(radiance, count, wavelengths, "radiance"), array(pdf_per_nm, count, wavelengths, "pdf_per_nm")};
}

auto xyz_of(std::span<const float> xyz) {
    return [xyz](std::size_t i) noexcept { return XYZ{xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]}; };
}

auto xyz_of(const emulsion::RgbInput& input, std::span<const float> rgb) {
    return [&input, rgb](std::size_t i) noexcept { return input.to_xyz({rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]}); };
}

emulsion::RgbInput rgb_input(const emulsion::FilmTile& tile, const char* space) {
    return emulsion::RgbInput(emulsion::rgb_space(&dereference(space, "space")), tile.setup().sensor.imaging_ratio());
}

emulsion::FilmTile& tile_for_splats(emulsion_tile* tile) {
    emulsion::FilmTile& to = dereference(tile, "tile").tile;
    if (to.setup().options.light_splats) return to;
    throw std::invalid_argument("the film was made without light_splats");
}

constexpr auto kSampled = emulsion::FilterUse::importance_sampled, kSplatted = emulsion::FilterUse::splatted;

}  // namespace

emulsion_status emulsion_tile_create(const emulsion_film* film, emulsion_rect places, emulsion_tile** tile) {
    return guarded([&] {
        emulsion_tile*& to = dereference(tile, "tile");
        const emulsion::Film& of = dereference(film, "film").film;
        to = new emulsion_tile{of.make_tile({places.x0, places.y0, places.x1, places.y1})};
    });
}

emulsion_status emulsion_tile_destroy(emulsion_tile* tile) {
    delete tile;
    return EMULSION_OK;
}

emulsion_status emulsion_tile_clear(emulsion_tile* tile) {
    return guarded([&] { dereference(tile, "tile").tile.clear(); });
}

emulsion_status emulsion_tile_set_sample_index(emulsion_tile* tile, uint64_t index) {
    return guarded([&] { dereference(tile, "tile").tile.set_sample_index(index); });
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
        add_batch(tile_for(tile, kSampled), pixels(count, x_px, y_px, weight),
                  spectra(count, wavelengths, lambda_nm, radiance, pdf_per_nm));
    });
}

emulsion_status emulsion_tile_add_xyz(emulsion_tile* tile, size_t count, const int32_t* x_px, const int32_t* y_px,
                                      const float* weight, const float* xyz) {
    return guarded([&] {
        add_batch(tile_for(tile, kSampled), pixels(count, x_px, y_px, weight), xyz_of(array(xyz, count, 3, "xyz")));
    });
}

emulsion_status emulsion_tile_add_rgb(emulsion_tile* tile, size_t count, const int32_t* x_px, const int32_t* y_px,
                                      const float* weight, const char* space, const float* rgb) {
    return guarded([&] {
        emulsion::FilmTile& to = tile_for(tile, kSampled);
        const emulsion::RgbInput input = rgb_input(to, space);
        add_batch(to, pixels(count, x_px, y_px, weight), xyz_of(input, array(rgb, count, 3, "rgb")));
    });
}

emulsion_status emulsion_tile_add_at_spectral(emulsion_tile* tile, size_t count, const float* x_px, const float* y_px,
                                              size_t wavelengths, const float* lambda_nm, const float* radiance,
                                              const float* pdf_per_nm) {
    return guarded([&] {
        add_batch_at(tile_for(tile, kSplatted), places(count, x_px, y_px),
                     spectra(count, wavelengths, lambda_nm, radiance, pdf_per_nm));
    });
}

emulsion_status emulsion_tile_add_at_xyz(emulsion_tile* tile, size_t count, const float* x_px, const float* y_px,
                                         const float* xyz) {
    return guarded([&] {
        add_batch_at(tile_for(tile, kSplatted), places(count, x_px, y_px), xyz_of(array(xyz, count, 3, "xyz")));
    });
}

emulsion_status emulsion_tile_add_at_rgb(emulsion_tile* tile, size_t count, const float* x_px, const float* y_px,
                                         const char* space, const float* rgb) {
    return guarded([&] {
        emulsion::FilmTile& to = tile_for(tile, kSplatted);
        const emulsion::RgbInput input = rgb_input(to, space);
        add_batch_at(to, places(count, x_px, y_px), xyz_of(input, array(rgb, count, 3, "rgb")));
    });
}

emulsion_status emulsion_tile_splat_spectral(emulsion_tile* tile, size_t count, const float* x_px, const float* y_px,
                                             size_t wavelengths, const float* lambda_nm, const float* radiance,
                                             const float* pdf_per_nm) {
    return guarded([&] {
        splat_batch(tile_for_splats(tile), places(count, x_px, y_px),
                    spectra(count, wavelengths, lambda_nm, radiance, pdf_per_nm));
    });
}

emulsion_status emulsion_tile_splat_xyz(emulsion_tile* tile, size_t count, const float* x_px, const float* y_px,
                                        const float* xyz) {
    return guarded(
        [&] { splat_batch(tile_for_splats(tile), places(count, x_px, y_px), xyz_of(array(xyz, count, 3, "xyz"))); });
}
