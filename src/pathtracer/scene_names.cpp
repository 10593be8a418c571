#include "pathtracer/scene_names.h"

#include <algorithm>
#include <cctype>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace emulsion {

namespace {

constexpr std::size_t kLongestName = 64;  // no known name comes near this; keeps garbage cheap

char lower(char c) noexcept { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

/// Letters to put in, leave out or change (Levenshtein), twice, plus 1 if only the case differs somewhere.
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (const char letter : a) {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t change = lower(letter) == lower(b[j]) ? 0 : 1;
            const std::size_t best = std::min({row[j] + 1, row[j + 1] + 1, diagonal + change});
            diagonal = row[j + 1];
            row[j + 1] = best;
        }
    }
    return 2 * row[b.size()] + (a == b ? 0 : 1);
}

}  // namespace

std::string_view nearest_name(std::string_view name, std::span<const std::string_view> known) {
    if (known.empty() || name.size() > kLongestName) return {};
    const auto nearest = std::min_element(known.begin(), known.end(), [&](std::string_view a, std::string_view b) {
        return distance(name, a) < distance(name, b);
    });
    const bool unlike = distance(name, *nearest) / 2 >= std::max(name.size(), nearest->size());
    return unlike ? std::string_view{} : *nearest;
}

std::string nearest_hint(std::string_view name, std::span<const std::string_view> known) {
    constexpr std::size_t kFew = 24;
    const std::string_view nearest = nearest_name(name, known);
    if (!nearest.empty()) return fmt::format(" (nearest known name: {})", quote(nearest));
    if (known.size() > kFew) return "";
    return known.empty() ? std::string(" (none is known)") : fmt::format(" ({})", fmt::join(known, ", "));
}

void throw_unsupported(const SourcePlace& place, const NameRole& role, std::string_view name,
                       std::span<const KnownName> known) {
    std::vector<std::string_view> all, supported;
    bool known_to_pbrt = false;
    for (const KnownName& row : known) {
        all.push_back(row.name);
        if (row.support == Support::here) supported.push_back(row.name);
        known_to_pbrt |= row.name == name;
    }
    const std::string named = fmt::format("{} {}{}", role.what, quote(name), role.of);
    if (!known_to_pbrt) throw SceneError(place, "unknown " + named, "a known one" + nearest_hint(name, all));

    const std::string choice = supported.empty() ? "none" : fmt::format("{}", fmt::join(supported, ", "));
    throw SceneError(place, named,
                     "a supported one (known to pbrt-v4 and not yet supported here; supported: " + choice + ")");
}

}  // namespace emulsion
