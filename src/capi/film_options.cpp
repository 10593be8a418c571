#include "capi/film_options.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "capi/sized_struct.h"
#include "capi/status.h"
#include "core/named_value.h"
#include "film/film_options_text.h"

namespace emulsion::capi {

namespace {

[[noreturn]] void refuse(const char* field, std::int32_t number, const char* expected) {
    throw std::invalid_argument(std::string("film options: ") + field + " is " + std::to_string(number) +
                                ", expected " + expected);
}

FilterUse filter_use(std::int32_t number) {
    if (number == EMULSION_IMPORTANCE_SAMPLED) return FilterUse::importance_sampled;
    if (number == EMULSION_SPLATTED) return FilterUse::splatted;
    refuse("filter_use", number, "an emulsion_filter_use");
}

FilmVariance variance(std::int32_t number) {
    if (number == EMULSION_VARIANCE_NONE) return FilmVariance::none;
    if (number == EMULSION_VARIANCE_LUMINANCE) return FilmVariance::luminance;
    if (number == EMULSION_VARIANCE_XYZ) return FilmVariance::xyz;
    refuse("variance", number, "an emulsion_variance");
}

std::optional<PixelBounds> crop(const emulsion_rect& rect) {
    const PixelBounds bounds{rect.x0, rect.y0, rect.x1, rect.y1};
    if (bounds == PixelBounds{}) return std::nullopt;
    return bounds;
}

std::optional<SpectralBuckets> spectrum(const emulsion_film_options& options) {
    if (options.spectrum_count == 0) return std::nullopt;
    return SpectralBuckets{options.spectrum_count, options.spectrum_min_nm, options.spectrum_max_nm};
}

bool light_splats(std::int32_t number) {
    if (number != 0 && number != 1) refuse("light_splats", number, "0 or 1");
    return number == 1;
}

}  // namespace

emulsion_film_options default_film_options() noexcept {
    const FilmOptions film;
    const SpectralBuckets buckets;
    emulsion_film_options options{};
    options.size = sizeof options;
    options.width_px = film.width_px;
    options.height_px = film.height_px;
    options.exposure_time_s = film.sensor.exposure_time_s;
    options.iso = film.sensor.iso;
    options.observer = "cie_1931_2deg";
    options.filter = "box";
    options.filter_use = EMULSION_IMPORTANCE_SAMPLED;
    options.variance = EMULSION_VARIANCE_NONE;
    options.spectrum_min_nm = buckets.min_nm;
    options.spectrum_max_nm = buckets.max_nm;
    options.aux = "none";
    options.firefly_control = "none";
    return options;
}

FilmOptions film_options(const emulsion_film_options& given) {
    const emulsion_film_options options = complete(given, default_film_options(), "film options");
    FilmOptions film;
    film.width_px = options.width_px;
    film.height_px = options.height_px;
    film.sensor.exposure_time_s = options.exposure_time_s;
    film.sensor.iso = options.iso;
    film.sensor.observer = &dereference(options.observer, "film options: observer");
    film.crop = crop(options.crop);
    film.filter = parse_named<Filter>(&dereference(options.filter, "film options: filter"), "filter");
    film.filter_use = filter_use(options.filter_use);
    film.light_splats = light_splats(options.light_splats);
    film.variance = variance(options.variance);
    film.spectrum = spectrum(options);
    film.aux = parse_aux_layers(&dereference(options.aux, "film options: aux"));
    film.firefly_control = parse_named<FireflyControl>(
        &dereference(options.firefly_control, "film options: firefly_control"), "firefly control");
    return film;
}

}  // namespace emulsion::capi
