#pragma once
// What the handles of the C interface stand for.

#include "capi/emulsion.h"
#include "film/film.h"

// NOLINTBEGIN(readability-identifier-naming): the names of the C interface
struct emulsion_film {
    emulsion::Film film;
};

struct emulsion_tile {
    emulsion::FilmTile tile;
    // Of its film
    double imaging_ratio = 1.0;
    emulsion::FilterUse filter_use = emulsion::FilterUse::importance_sampled;
    bool light_splats = false;
};
// NOLINTEND(readability-identifier-naming)
