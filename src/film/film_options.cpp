#include "film/film_options.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string_view>
#include <variant>

#include "core/named_value.h"
#include "core/parameters.h"

namespace emulsion {

namespace {

void require_size(const char* field, int value) {
    constexpr int kLargest = 65536;
    if (value >= 1 && value <= kLargest) return;
    throw std::invalid_argument(std::string("film: ") + field + " is " + std::to_string(value) +
                                ", expected a number in [1, " + std::to_string(kLargest) + "]");
}

void require_crop(const FilmOptions& options) {
    if (!options.crop) return;
    const PixelBounds frame{0, 0, options.width_px, options.height_px};
    if (frame.contains(*options.crop)) return;
    throw std::invalid_argument("film: crop is " + to_string(*options.crop) + ", expected pixels inside " +
                                to_string(frame));
}

bool is_channel_word(std::string_view word) noexcept {
    return !word.empty() && word.size() <= 64 &&
           word.find_first_not_of(
               "abcdefghijklmnopqrstuvwxyz"
               "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
               "0123456789_-") == std::string_view::npos;
}

void require_channel_word(const std::string& field, const std::string& word) {
    if (is_channel_word(word)) return;
    throw std::invalid_argument(field + " is \"" + word + "\", expected 1 to 64 letters, digits, '-' and '_'");
}

/// Layers that the film's files have of themselves, and that of its spectrum.
void require_free(const std::string& layer) {
    for (const std::string_view taken : {"variance", "standard-error", "S0"}) {
        if (layer != taken) continue;
        throw std::invalid_argument("film: aux.name is \"" + layer +
                                    "\", expected a name that the film's files don't have");
    }
}

void validate(const std::vector<AuxLayer>& layers) {
    constexpr std::size_t kMostComponents = 16;
    std::set<std::string> names;
    for (const AuxLayer& layer : layers) {
        require_channel_word("film: aux.name", layer.name);
        require_free(layer.name);
        if (!names.insert(layer.name).second) {
            throw std::invalid_argument("film: aux.name is \"" + layer.name + "\" twice, expected different names");
        }
        const std::string field = "film: aux \"" + layer.name + "\": components";
        if (layer.components.empty() || layer.components.size() > kMostComponents) {
            throw std::invalid_argument(field + " has " + std::to_string(layer.components.size()) +
                                        " entries, expected 1 to 16");
        }
        for (const std::string& component : layer.components) require_channel_word(field, component);
        if (std::set(layer.components.begin(), layer.components.end()).size() != layer.components.size()) {
            throw std::invalid_argument(field + " has an entry twice, expected different ones");
        }
    }
}

std::string aux_text(const std::vector<AuxLayer>& layers) {
    std::string text;
    for (const AuxLayer& layer : layers) {
        text += (text.empty() ? "" : ",") + layer.name + ":";
        for (std::size_t i = 0; i < layer.components.size(); ++i) text += (i > 0 ? "+" : "") + layer.components[i];
    }
    return text.empty() ? "none" : text;
}

}  // namespace

const std::vector<AuxLayer>& known_aux_layers() {
    static const std::vector<AuxLayer> layers = {
        {"albedo", {"R", "G", "B"}}, {"normal", {"X", "Y", "Z"}}, {"depth", {"Z"}}};
    return layers;
}

AuxLayer known_aux_layer(const std::string& name) {
    std::vector<std::string_view> names;
    for (const AuxLayer& layer : known_aux_layers()) {
        if (layer.name == name) return layer;
        names.emplace_back(layer.name);
    }
    throw_unknown_name("auxiliary layer", name, names);
}

PixelBounds bounds_of(const FilmOptions& options) noexcept {
    return options.crop.value_or(PixelBounds{0, 0, options.width_px, options.height_px});
}

void validate(const FilmOptions& options) {
    require_size("width_px", options.width_px);
    require_size("height_px", options.height_px);
    require_crop(options);
    validate(options.sensor);
    validate(options.filter);
    if (options.spectrum) validate(*options.spectrum);
    validate(options.aux);
    validate_named(options.firefly_control, "firefly control");
}

void validate_clamp(const FilmOptions& options) {
    const auto* const clamp = std::get_if<LuminanceClamp>(&options.firefly_control);
    if (clamp == nullptr) return;
    const double ratio = imaging_ratio(options.sensor);
    const auto limit = static_cast<float>(static_cast<double>(clamp->max_luminance_cdm2) * ratio);
    // In single precision, as it is used and as 1e30 is read: that is a little more than 1e30.
    if (limit >= static_cast<float>(kMinImagingRatio) && limit <= static_cast<float>(kMaxImagingRatio)) return;
    throw std::invalid_argument("film: firefly control clamp: luminance is " + number_text(clamp->max_luminance_cdm2) +
                                " cd/m^2, which times the imaging ratio " + number_text(ratio) + " is " +
                                number_text(limit) + ", expected a product in [1e-30, 1e+30]");
}

std::string to_text(const FilmOptions& options) {
    std::string text = "filter=" + to_text(options.filter);
    text += options.filter_use == FilterUse::splatted ? " filter-use=splatted" : " filter-use=importance-sampled";
    text += options.light_splats ? " light-splats=yes" : " light-splats=no";
    text += " variance=";
    text += options.variance == FilmVariance::none        ? "none"
            : options.variance == FilmVariance::luminance ? "luminance"
                                                          : "xyz";
    text += " spectrum=";
    text += options.spectrum ? std::to_string(options.spectrum->count) + ":" + number_text(options.spectrum->min_nm) +
                                   "-" + number_text(options.spectrum->max_nm)
                             : "none";
    text += " aux=" + aux_text(options.aux);
    text += " firefly-control=" + to_text(options.firefly_control);
    return text;
}

}  // namespace emulsion
