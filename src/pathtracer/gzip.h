#pragma once
// Files compressed by gzip.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace emulsion {

/// A small file can hold a thousand times its size: more than this is refused, 2 GiB.
inline constexpr std::size_t kMostInflatedBytes = std::size_t{1} << 31u;

/// What `compressed`, the bytes of a gzip file of one or more members, stands for.
/// \throws IoError, naming `path`, if it is no such file, damaged or cut off, or if it holds more than `most_bytes`.
[[nodiscard]] std::string inflate_gzip(const std::filesystem::path& path, std::string_view compressed,
                                       std::size_t most_bytes = kMostInflatedBytes);

}  // namespace emulsion
