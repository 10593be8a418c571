#pragma once
// What helps to choose a tone mapping operator: a list, a sheet of pictures, a curve.

#include <filesystem>
#include <string>

#include "core/color.h"
#include "core/image.h"
#include "develop/pipeline.h"

namespace emulsion::cli {

/// One block for each operator, or each adaptation: the name at the start of a line; below it, indented, what it does
/// and its parameters, each with default, range, unit and a line of help.
[[nodiscard]] std::string tonemap_list();
[[nodiscard]] std::string adaptation_list();

/// One tile for each operator: see contact_sheet(). \throws IoError if the file can't be written.
void write_contact_sheet(const std::filesystem::path& png, const Image<XYZ>& scene, const Pipeline& pipeline,
                         int threads);

/// Three exposures: see exposure_tiles(). Around the white of the pipeline's tone mapper if that is `fixed`, else
/// around a tenth of the picture's robust largest luminance. \throws IoError if the file can't be written.
void write_exposures(const std::filesystem::path& png, const Image<XYZ>& scene, const Pipeline& pipeline, int threads);

/// CSV: two lines of comment, then "luminance_cdm2,display_luminance" and a row for each point of tone_curve().
/// \throws IoError if the file can't be written.
void write_curve(const std::filesystem::path& csv, const Image<XYZ>& scene, const Pipeline& pipeline, int threads);

}  // namespace emulsion::cli
