#include "film/film_options_text.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/named_value.h"
#include "core/parameters.h"

namespace emulsion {

namespace {

[[noreturn]] void refuse(std::string_view what, std::string_view found) {
    throw std::invalid_argument("film options: found \"" + std::string(found) + "\", expected " + std::string(what));
}

/// The parts between separators; of empty text, one that is empty.
std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

/// The text before a separator and that behind it; which must be there.
std::pair<std::string_view, std::string_view> cut(std::string_view text, char separator, std::string_view what) {
    const std::size_t at = text.find(separator);
    if (at == std::string_view::npos) refuse(what, text);
    return {text.substr(0, at), text.substr(at + 1)};
}

FilmVariance parse_variance(std::string_view text) {
    if (text == "none") return FilmVariance::none;
    if (text == "luminance") return FilmVariance::luminance;
    if (text == "xyz") return FilmVariance::xyz;
    refuse("a variance: none, luminance or xyz", text);
}

FilterUse parse_filter_use(std::string_view text) {
    if (text == "importance-sampled") return FilterUse::importance_sampled;
    if (text == "splatted") return FilterUse::splatted;
    refuse("a filter-use: importance-sampled or splatted", text);
}

std::optional<SpectralBuckets> parse_spectrum(std::string_view text) {
    if (text == "none") return std::nullopt;
    constexpr const char* kWhat = "a spectrum: none, or buckets:nm-nm";
    const auto [count, range] = cut(text, ':', kWhat);
    // A minus sign of an exponent is none between two numbers.
    std::size_t minus = range.find('-');
    if (minus != std::string_view::npos && minus > 0 && range[minus - 1] == 'e') minus = range.find('-', minus + 1);
    if (minus == std::string_view::npos) refuse(kWhat, text);
    SpectralBuckets buckets;
    parse_number(count, "film options: spectrum", buckets.count);
    parse_number(range.substr(0, minus), "film options: spectrum", buckets.min_nm);
    parse_number(range.substr(minus + 1), "film options: spectrum", buckets.max_nm);
    return buckets;
}

AuxLayer parse_aux_layer(std::string_view text) {
    for (const AuxLayer& known : known_aux_layers()) {
        if (text == known.name) return known;
    }
    const auto [name, components] =
        cut(text, ':', "auxiliary layers: name:component+component, or albedo, normal and depth by their names");
    AuxLayer layer{std::string(name), {}};
    for (const std::string_view component : split(components, '+')) layer.components.emplace_back(component);
    return layer;
}

}  // namespace

std::vector<AuxLayer> parse_aux_layers(std::string_view text) {
    std::vector<AuxLayer> layers;
    // A layer cannot be named so without components.
    if (text == "none") return layers;
    for (const std::string_view layer : split(text, ',')) layers.push_back(parse_aux_layer(layer));
    return layers;
}

std::string_view film_option_text(std::string_view text, std::string_view name) {
    for (const std::string_view part : split(text, ' ')) {
        const auto [found, value] = cut(part, '=', "options: name=value");
        if (found == name) return value;
    }
    refuse("an option " + std::string(name), text);
}

FilmOptions parse_film_options(std::string_view text) {
    FilmOptions options;
    options.filter = parse_named<Filter>(film_option_text(text, "filter"), "filter");
    options.filter_use = parse_filter_use(film_option_text(text, "filter-use"));
    options.light_splats = film_option_text(text, "light-splats") == "yes";
    options.variance = parse_variance(film_option_text(text, "variance"));
    options.spectrum = parse_spectrum(film_option_text(text, "spectrum"));
    options.aux = parse_aux_layers(film_option_text(text, "aux"));
    options.firefly_control = parse_named<FireflyControl>(film_option_text(text, "firefly-control"), "firefly control");
    validate(options);
    if (to_text(options) != text) refuse(to_text(options), text);
    return options;
}

}  // namespace emulsion
