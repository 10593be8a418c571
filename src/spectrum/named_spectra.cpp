#include "spectrum/named_spectra.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>

#include "spectrum/catalogue.h"
#include "spectrum/spectrum_daylight.h"

namespace emulsion {

namespace {

constexpr std::array<std::string_view, 3> kScenePrefixes = {"stdillum-", "metal-", "glass-"};

constexpr std::string_view kAcesWhite = "illum-acesD60";
constexpr std::array<std::string_view, 7> kPbrtGlasses = {"BK7", "BAF10", "FK51A", "LASF9", "F5", "F10", "F11"};

// pbrt-v4's names other than those of glasses, metals and standard illuminants; the sensors have _r, _g and _b added.
constexpr std::array<std::string_view, 7> kPbrtMetals = {"Ag", "Al", "Au", "Cu", "CuZn", "MgO", "TiO2"};
constexpr std::array<std::string_view, 17> kPbrtSensors = {
    "canon_eos_100d",     "canon_eos_1dx_mkii", "canon_eos_200d",    "canon_eos_200d_mkii", "canon_eos_5d",
    "canon_eos_5d_mkii",  "canon_eos_5d_mkiii", "canon_eos_5d_mkiv", "canon_eos_5ds",       "canon_eos_m",
    "hasselblad_l1d_20c", "nikon_d810",         "nikon_d850",        "sony_ilce_6400",      "sony_ilce_7m3",
    "sony_ilce_7rm3",     "sony_ilce_9"};

// The names of the catalogue that scenes may use, letter by letter.
const std::map<std::string, const NamedSpectrumInfo*, std::less<>>& scene_names() {
    static const std::map<std::string, const NamedSpectrumInfo*, std::less<>> names = [] {
        std::map<std::string, const NamedSpectrumInfo*, std::less<>> made;
        const auto add = [&](const std::string& name, const NamedSpectrumInfo& entry) {
            const auto starts_name = [&](std::string_view prefix) { return name.starts_with(prefix); };
            if (std::any_of(kScenePrefixes.begin(), kScenePrefixes.end(), starts_name)) made[name] = &entry;
        };
        for (const NamedSpectrumInfo& entry : spectrum_catalogue()) {
            add(entry.name, entry);
            for (const std::string& alias : entry.aliases) add(alias, entry);
        }
        return made;
    }();
    return names;
}

// Takes `prefix` off the front of `name`.
bool consume(std::string_view& name, std::string_view prefix) noexcept {
    if (!name.starts_with(prefix)) return false;
    name.remove_prefix(prefix.size());
    return true;
}

template <std::size_t N>
bool contains(const std::array<std::string_view, N>& names, std::string_view name) noexcept {
    return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

std::optional<Spectrum> named_spectrum(std::string_view name) {
    if (name == kAcesWhite) return DaylightSpectrum{.temperature_K = 6000.0};
    const auto found = scene_names().find(name);
    if (found == scene_names().end()) return std::nullopt;
    return spectrum_of(*found->second);
}

std::vector<std::string> named_spectrum_names() {
    std::vector<std::string> names;
    for (const auto& [name, entry] : scene_names()) names.push_back(name);
    names.insert(std::ranges::upper_bound(names, kAcesWhite), std::string(kAcesWhite));
    return names;
}

bool is_known_to_pbrt(std::string_view name) noexcept {
    if (name == kAcesWhite) return true;
    if (consume(name, "glass-")) return contains(kPbrtGlasses, name);
    if (consume(name, "stdillum-")) {
        constexpr std::array<std::string_view, 15> kNames = {"A",  "D50", "D65", "F1", "F2",  "F3",  "F4", "F5",
                                                             "F6", "F7",  "F8",  "F9", "F10", "F11", "F12"};
        return contains(kNames, name);
    }
    if (consume(name, "metal-")) {
        const std::size_t dash = name.find('-');
        if (dash == std::string_view::npos) return false;
        const std::string_view part = name.substr(dash);
        return (part == "-eta" || part == "-k") && contains(kPbrtMetals, name.substr(0, dash));
    }
    if (name.ends_with("_r") || name.ends_with("_g") || name.ends_with("_b")) {
        return contains(kPbrtSensors, name.substr(0, name.size() - 2));
    }
    return false;
}

}  // namespace emulsion
