#pragma once
// FilmMetadata in OpenEXR's headers.

#include <string>
#include <vector>

#include <OpenEXR/ImfHeader.h>

#include "film/exr_file.h"

namespace emulsion {

void write_metadata(const FilmMetadata& metadata, Imf::Header& header);

/// Fields that the header does not have keep their defaults; `notes` gets a sentence for each that is no value of its
/// field.
[[nodiscard]] FilmMetadata read_metadata(const Imf::Header& header, std::vector<std::string>& notes);

}  // namespace emulsion
