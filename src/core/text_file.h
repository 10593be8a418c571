#pragma once
// Whole text files.

#include <filesystem>
#include <string>
#include <string_view>

namespace emulsion {

/// The bytes of a file or of a pipe.
/// \throws IoError if there is no such file, if it is a folder or a device (which may never end), if it can't be
/// opened, and if reading it fails.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& path);

/// The file appears whole or not at all; see AtomicFile. \throws IoError if it can't be written.
void write_text_file(const std::filesystem::path& path, std::string_view text);

}  // namespace emulsion
