#pragma once
// Whole text files.

#include <filesystem>
#include <string>

namespace emulsion {

/// The bytes of a file or of a pipe.
/// \throws IoError if there is no such file, if it is a folder or a device (which may never end), if it can't be
/// opened, and if reading it fails.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& path);

}  // namespace emulsion
