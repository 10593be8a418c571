// The C interface: films.

#include "film/film.h"

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "capi/emulsion.h"
#include "capi/film_options.h"
#include "capi/handles.h"
#include "capi/sized_struct.h"
#include "capi/status.h"

namespace {

using emulsion::capi::default_film_options;
using emulsion::capi::dereference;
using emulsion::capi::film_options;
using emulsion::capi::guarded;

}  // namespace

emulsion_status emulsion_film_options_init(emulsion_film_options* options, size_t size) {
    return guarded([&] {
        emulsion::capi::initialise(dereference(options, "options"), size, default_film_options(), "film options");
    });
}

emulsion_status emulsion_film_create(const emulsion_film_options* options, emulsion_film** film) {
    return guarded([&] {
        emulsion_film*& to = dereference(film, "film");
        to = new emulsion_film{emulsion::Film(film_options(dereference(options, "options")))};
    });
}

emulsion_status emulsion_film_destroy(emulsion_film* film) {
    delete film;
    return EMULSION_OK;
}

emulsion_status emulsion_film_bounds(const emulsion_film* film, emulsion_rect* bounds) {
    return guarded([&] {
        const emulsion::PixelBounds of_film = dereference(film, "film").film.bounds();
        dereference(bounds, "bounds") = {of_film.x0, of_film.y0, of_film.x1, of_film.y1};
    });
}

emulsion_status emulsion_film_sample_bounds(const emulsion_film* film, emulsion_rect* bounds) {
    return guarded([&] {
        const emulsion::PixelBounds places = dereference(film, "film").film.sample_bounds();
        dereference(bounds, "bounds") = {places.x0, places.y0, places.x1, places.y1};
    });
}

emulsion_status emulsion_film_merge_tile(emulsion_film* film, const emulsion_tile* tile) {
    return guarded([&] { dereference(film, "film").film.merge(dereference(tile, "tile").tile); });
}

emulsion_status emulsion_film_merge_film(emulsion_film* film, const emulsion_film* other) {
    return guarded([&] { dereference(film, "film").film.merge(dereference(other, "other").film); });
}

emulsion_status emulsion_film_add_light_paths(emulsion_film* film, uint64_t paths) {
    return guarded([&] { dereference(film, "film").film.add_light_paths(paths); });
}

emulsion_status emulsion_film_sample_count(const emulsion_film* film, uint64_t* count) {
    return guarded([&] { dereference(count, "count") = dereference(film, "film").film.sample_count(); });
}

emulsion_status emulsion_film_dropped_count(const emulsion_film* film, int32_t kind, uint64_t* count) {
    using emulsion::DroppedKind;
    constexpr std::array kKinds = {DroppedKind::nan, DroppedKind::infinite, DroppedKind::negative_luminance};
    return guarded([&] {
        const auto number = static_cast<std::size_t>(kind);
        if (number >= kKinds.size()) {
            throw std::invalid_argument("kind is " + std::to_string(kind) + ", expected an emulsion_dropped_kind");
        }
        dereference(count, "count") = dereference(film, "film").film.dropped().count(kKinds[number]);
    });
}

emulsion_status emulsion_film_clamped_count(const emulsion_film* film, uint64_t* count) {
    return guarded([&] { dereference(count, "count") = dereference(film, "film").film.counts().clamped.count; });
}

emulsion_status emulsion_film_faint_count(const emulsion_film* film, uint64_t* count) {
    return guarded([&] { dereference(count, "count") = dereference(film, "film").film.counts().faint; });
}

emulsion_status emulsion_film_pixels_without_value(const emulsion_film* film, uint64_t* count) {
    return guarded([&] {
        dereference(count, "count") = static_cast<std::uint64_t>(dereference(film, "film").film.pixels_without_value());
    });
}

emulsion_status emulsion_film_saturated_pixels(const emulsion_film* film, uint64_t* count) {
    return guarded([&] {
        dereference(count, "count") = static_cast<std::uint64_t>(dereference(film, "film").film.saturated_pixels());
    });
}
