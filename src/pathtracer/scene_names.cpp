#include "pathtracer/scene_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace emulsion {

std::string nearest_hint(std::string_view name, std::span<const std::string_view> known) {
    constexpr std::size_t kFew = 24, kMost = 1000;
    if (known.size() > kMost) return "";  // many messages about many names would take for ever
    const std::string_view nearest = nearest_name(name, known);
    if (!nearest.empty()) return fmt::format(" (nearest known name: {})", quote(nearest));
    if (known.size() > kFew) return "";
    return known.empty() ? std::string(" (none is known)") : fmt::format(" ({})", fmt::join(known, ", "));
}

void throw_unsupported(const SourcePlace& place, const NameRole& role, std::string_view name,
                       std::span<const KnownName> known) {
    std::vector<std::string_view> all, supported;
    bool known_to_pbrt = false;
    std::string_view advice;
    for (const KnownName& row : known) {
        all.push_back(row.name);
        if (row.support == Support::here) supported.push_back(row.name);
        if (row.name != name) continue;
        known_to_pbrt = true;
        advice = row.advice;
    }
    const std::string named = fmt::format("{} {}{}", role.what, quote(name), role.of);
    if (!known_to_pbrt) throw SceneError(place, "unknown " + named, "a known one" + nearest_hint(name, all));

    if (!advice.empty()) throw SceneError(place, named, fmt::format("a supported one ({})", advice));
    const std::string choice = supported.empty() ? "none" : fmt::format("{}", fmt::join(supported, ", "));
    throw SceneError(place, named,
                     "a supported one (known to pbrt-v4 and not yet supported here; supported: " + choice + ")");
}

}  // namespace emulsion
