#pragma once
// Known names: those that we support, and those that pbrt-v4 has and we don't yet. Errors tell the two apart, and
// answer an unknown name with the nearest known one.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/nearest_name.h"
#include "pathtracer/scene_source.h"

namespace emulsion {

enum class Support {
    here,       ///< read, and means what it means to pbrt-v4
    pbrt_only,  ///< known to pbrt-v4, not yet supported here
};

struct KnownName {
    std::string_view name;
    Support support = Support::here;
    std::string_view advice = {};  ///< what to do if it is not supported
};

/// " (nearest known name: "sphere")"; the list of names if none is near and they are few; else nothing.
[[nodiscard]] std::string nearest_hint(std::string_view name, std::span<const std::string_view> known);

/// What a name names, for messages: parameter "name" of shape "sphere".
struct NameRole {
    std::string_view what;     ///< "shape", "parameter"
    std::string_view of = {};  ///< " of shape "sphere"", or nothing
};

/// \throws SceneError always: the name is unknown, or known to pbrt-v4 only.
[[noreturn]] void throw_unsupported(const SourcePlace& place, const NameRole& role, std::string_view name,
                                    std::span<const KnownName> known);

/// The row of a table whose `name` is as given and whose `support`, if rows have one, is here.
/// \throws SceneError if there is none.
template <class Row>
[[nodiscard]] const Row& supported_row(const SourcePlace& place, const NameRole& role, std::string_view name,
                                       std::span<const Row> table) {
    const auto support_of = [](const Row& row) {
        if constexpr (requires { row.support; }) return row.support;
        return Support::here;
    };
    const auto advice_of = [](const Row& row) {
        if constexpr (requires { row.advice; }) return row.advice;
        return std::string_view();
    };
    for (const Row& row : table) {
        if (row.name == name && support_of(row) == Support::here) return row;
    }
    std::vector<KnownName> known;
    for (const Row& row : table) known.push_back({row.name, support_of(row), advice_of(row)});
    throw_unsupported(place, role, name, known);
}

}  // namespace emulsion
