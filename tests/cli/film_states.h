#pragma once
// Film states as a renderer leaves them, for the program to work on.

#include <cstdint>
#include <limits>
#include <string>

#include "core/random.h"
#include "film/film_state.h"

namespace emulsion::testing {

inline FilmOptions small_film() {
    return {.width_px = 12, .height_px = 8, .sensor = {.exposure_time_s = 0.5}, .variance = FilmVariance::luminance};
}

/// Samples [begin, end) of every pixel, one of them NaN in the first range.
inline FilmState film_state(const FilmOptions& options, std::uint64_t begin, std::uint64_t end) {
    Film film(options);
    FilmTile tile = film.make_tile(film.bounds());
    for (std::uint64_t index = begin; index < end; ++index) {
        for (int y = film.bounds().y0; y < film.bounds().y1; ++y) {
            for (int x = film.bounds().x0; x < film.bounds().x1; ++x) {
                Pcg32 random(static_cast<std::uint64_t>(y * 100 + x), index);
                XYZ value{random.next_float(), 100.0f * random.next_float(), random.next_float()};
                if (x == 3 && y == 2 && index == 0) value.z = std::numeric_limits<float>::quiet_NaN();
                tile.add(x, y, value, 1.0f);
            }
        }
    }
    film.merge(tile);
    FilmProvenance provenance{.scene = "cafe0123", .sampling = "independent seed=7"};
    provenance.samples.add(SampleRange{begin, end});
    return state_of(film, provenance, {.seed = 7, .renderer_version = "test 1", .command_line = "render it"});
}

}  // namespace emulsion::testing
