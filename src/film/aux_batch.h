#pragma once
// Values of auxiliary layers in batches, beside the samples that they belong to (film/sample_batch.h): whole or not at
// all, and bit for bit what as many calls of BasicFilmTile::add_aux give.

#include <cstddef>
#include <span>
#include <vector>

#include "film/film_options.h"
#include "film/film_tile.h"
#include "film/sample_batch.h"

namespace emulsion {

/// What samples see of one layer. Those that see nothing are left out of the batch.
struct BatchAux {
    std::size_t layer = 0;          ///< its place in FilmOptions::aux
    std::span<const float> values;  ///< as many as the layer has components, those of one sample side by side
};

/// For so many samples.
/// \throws std::invalid_argument unless there is such a layer, and an array of its length.
void validate(const BatchAux& aux, const std::vector<AuxLayer>& layers, std::size_t samples);

/// As BasicFilmTile::add_aux. \throws std::invalid_argument as validate() does, with the tile as it was.
template <class Sums>
void add_aux_batch(BasicFilmTile<Sums>& tile, const BatchPixels& pixels, const BatchAux& aux) {
    const std::vector<AuxLayer>& layers = tile.setup().options.aux;
    validate(pixels, tile.bounds());
    validate(aux, layers, pixels.x_px.size());
    const std::size_t size = layers[aux.layer].components.size();
    detail::for_each_sample(pixels, [&](std::size_t i, int x, int y, float weight) {
        tile.add_aux(x, y, aux.layer, aux.values.subspan(i * size, size), weight);
    });
}

/// As BasicFilmTile::add_aux_at. \throws std::invalid_argument as validate() does, with the tile as it was.
template <class Sums>
void add_aux_batch_at(BasicFilmTile<Sums>& tile, const BatchPlaces& places, const BatchAux& aux) {
    const std::vector<AuxLayer>& layers = tile.setup().options.aux;
    validate(places, tile.places());
    validate(aux, layers, places.x_px.size());
    const std::size_t size = layers[aux.layer].components.size();
    detail::for_each_sample(places, [&](std::size_t i, float x_px, float y_px) {
        tile.add_aux_at(x_px, y_px, aux.layer, aux.values.subspan(i * size, size));
    });
}

}  // namespace emulsion
