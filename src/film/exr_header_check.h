#pragma once
// A look at an EXR's header before OpenEXR sees it: sizes that the file cannot hold are refused before anybody
// allocates memory for them. Source: "OpenEXR File Layout", openexr.com.

#include <filesystem>

namespace emulsion {

/// \throws IoError if the file is missing, not a regular file, empty, not an EXR, of several parts or deep; if an
/// attribute ends past the file's end; or if the data window or the tiles hold more pixels than such a file can.
void check_exr_header(const std::filesystem::path& path);

}  // namespace emulsion
