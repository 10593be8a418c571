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
};
// NOLINTEND(readability-identifier-naming)
