#pragma once
// A look at an EXR's headers before OpenEXR sees them: sizes that the file cannot hold are refused before anybody
// allocates memory for them. Source: "OpenEXR File Layout", openexr.com.

#include <filesystem>

namespace emulsion {

/// \throws IoError if the file is missing, not a regular file, empty, not an EXR, or deep in any part; if an attribute
/// ends past the file's end; or if the data windows, tiles and chunks of all parts together hold more than such a file
/// can.
void check_exr_header(const std::filesystem::path& path);

}  // namespace emulsion
