#pragma once
// When two names given by a user mean the same.

#include <string>
#include <string_view>

namespace emulsion {

/// The name in small letters, with '-' for each of '_', '.' and the space: names with the same key are the same name.
/// "FL3.10", "fl3_10" and "FL3-10" are; letters other than A to Z are taken as they stand.
[[nodiscard]] std::string name_key(std::string_view name);

}  // namespace emulsion
