// The C interface: auxiliary layers.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "capi/batch_arrays.h"
#include "capi/emulsion.h"
#include "capi/handles.h"
#include "capi/pixel_numbers.h"
#include "capi/status.h"
#include "core/named_value.h"
#include "film/aux_batch.h"
#include "film/film.h"

namespace {

using emulsion::AuxLayer;
using emulsion::BatchAux;
using emulsion::capi::array;
using emulsion::capi::dereference;
using emulsion::capi::guarded;
using emulsion::capi::tile_for;

/// The place of the layer of that name. \throws std::invalid_argument if there is none, with the names that there are.
std::size_t place_of(const char* layer, const std::vector<AuxLayer>& layers) {
    const std::string_view name = &dereference(layer, "layer");
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        if (layers[i].name == name) return i;
        names.emplace_back(layers[i].name);
    }
    emulsion::throw_unknown_name("auxiliary layer", name, names);
}

BatchAux aux(const emulsion::FilmTile& tile, std::size_t count, const char* layer, const float* values) {
    const std::vector<AuxLayer>& layers = tile.setup().options.aux;
    const std::size_t place = place_of(layer, layers);
    return {place, array(values, count, layers[place].components.size(), "values")};
}

}  // namespace

emulsion_status emulsion_tile_add_aux(emulsion_tile* tile, size_t count, const int32_t* x_px, const int32_t* y_px,
                                      const float* weight, const char* layer, const float* values) {
    return guarded([&] {
        emulsion::FilmTile& to = tile_for(tile, emulsion::FilterUse::importance_sampled);
        const emulsion::BatchPixels at = emulsion::capi::pixels(count, x_px, y_px, weight);
        add_aux_batch(to, at, aux(to, count, layer, values));
    });
}

emulsion_status emulsion_tile_add_aux_at(emulsion_tile* tile, size_t count, const float* x_px, const float* y_px,
                                         const char* layer, const float* values) {
    return guarded([&] {
        emulsion::FilmTile& to = tile_for(tile, emulsion::FilterUse::splatted);
        const emulsion::BatchPlaces at = emulsion::capi::places(count, x_px, y_px);
        add_aux_batch_at(to, at, aux(to, count, layer, values));
    });
}

emulsion_status emulsion_film_dropped_aux_count(const emulsion_film* film, uint64_t* count) {
    return guarded([&] { dereference(count, "count") = dereference(film, "film").film.counts().dropped_aux; });
}

emulsion_status emulsion_film_read_aux(const emulsion_film* film, const char* layer, float* values, size_t length) {
    return guarded([&] {
        const emulsion::Film& from = dereference(film, "film").film;
        const std::size_t place = place_of(layer, from.options().aux);
        const std::size_t size = from.options().aux[place].components.size();
        const std::span<float> to = emulsion::capi::pixel_numbers(values, length, from, size, "values");
        from.for_each_pixel([&](std::size_t i, const emulsion::PixelSums& sums) {
            for (std::size_t k = 0; k < size; ++k) {
                to[i * size + k] = static_cast<float>(aux_value_of(sums, from.setup(), place, k));
            }
        });
    });
}
