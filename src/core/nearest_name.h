#pragma once
// Names that are like a misspelt one.

#include <cstddef>
#include <span>
#include <string_view>

namespace emulsion {

/// Letters to put in, leave out or change (Levenshtein's distance), twice, where letters that differ only in their case
/// count as the same; plus 1 if the names are not the same for all that.
[[nodiscard]] std::size_t name_distance(std::string_view a, std::string_view b);

/// The known name with the least distance, the first of several; empty if there are none, or `name` is beyond any
/// likeness.
[[nodiscard]] std::string_view nearest_name(std::string_view name, std::span<const std::string_view> known);

}  // namespace emulsion
