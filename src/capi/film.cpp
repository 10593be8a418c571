// The C interface: films.

#include "film/film.h"

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "capi/emulsion.h"
#include "capi/handles.h"
#include "capi/sized_struct.h"
#include "capi/status.h"
#include "core/named_value.h"

namespace {

using emulsion::capi::dereference;
using emulsion::capi::guarded;

emulsion_film_options default_film_options() {
    const emulsion::FilmOptions film;
    emulsion_film_options options{};
    options.size = sizeof options;
    options.width_px = film.width_px;
    options.height_px = film.height_px;
    options.exposure_time_s = film.sensor.exposure_time_s;
    options.iso = film.sensor.iso;
    options.observer = "cie_1931_2deg";
    options.filter = "box";
    options.filter_use = EMULSION_IMPORTANCE_SAMPLED;
    return options;
}

emulsion::FilterUse filter_use(std::int32_t number) {
    if (number == EMULSION_IMPORTANCE_SAMPLED) return emulsion::FilterUse::importance_sampled;
    if (number == EMULSION_SPLATTED) return emulsion::FilterUse::splatted;
    throw std::invalid_argument("film options: filter_use is " + std::to_string(number) +
                                ", expected an emulsion_filter_use");
}

emulsion::FilmOptions film_options(const emulsion_film_options& given) {
    const emulsion_film_options options = emulsion::capi::complete(given, default_film_options(), "film options");
    emulsion::FilmOptions film;
    film.width_px = options.width_px;
    film.height_px = options.height_px;
    film.sensor.exposure_time_s = options.exposure_time_s;
    film.sensor.iso = options.iso;
    film.sensor.observer = &dereference(options.observer, "film options: observer");
    const emulsion::PixelBounds crop{options.crop.x0, options.crop.y0, options.crop.x1, options.crop.y1};
    if (crop != emulsion::PixelBounds{}) film.crop = crop;
    film.filter =
        emulsion::parse_named<emulsion::Filter>(&dereference(options.filter, "film options: filter"), "filter");
    film.filter_use = filter_use(options.filter_use);
    if (options.light_splats != 0 && options.light_splats != 1) {
        throw std::invalid_argument("film options: light_splats is " + std::to_string(options.light_splats) +
                                    ", expected 0 or 1");
    }
    film.light_splats = options.light_splats == 1;
    return film;
}

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
