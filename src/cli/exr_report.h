#pragma once
// What `emulsion info` tells of an EXR file as such: its size, channels and parts.

#include "cli/info_report.h"
#include "film/exr_info.h"

namespace emulsion::cli {

/// Pixels of the picture, and where in the frame they lie.
void report_size(const ExrInfo& exr, InfoReport& report);

/// Colour space, layers, spectrum and compression of the picture, and the file's other parts.
/// \param white_luminance_cdm2 of the picture, if it is one that can be read
void report_channels(const ExrInfo& exr, double white_luminance_cdm2, InfoReport& report);

}  // namespace emulsion::cli
