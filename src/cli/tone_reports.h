#pragma once
// What helps to choose a tone mapping operator: a list, a sheet of pictures, a curve. Pictures are what is tone-mapped:
// scene-referred XYZ, Y in cd/m^2, after bloom and vision, which a pipeline given beside them must not have again.

#include <filesystem>
#include <string>

#include "core/color.h"
#include "core/image.h"
#include "develop/pipeline.h"
#include "tonemap/scene_luminance.h"
#include "tonemap/tone_mapper.h"

namespace emulsion::cli {

/// One block for each operator, or each adaptation: the name at the start of a line; below it, indented, what it does,
/// of operators their own adaptation, and parameters, each with default, range, unit and a line of help.
[[nodiscard]] std::string tonemap_list();
[[nodiscard]] std::string adaptation_list();

/// One tile for each operator, under the pipeline's adaptation, if it has one: see contact_sheet().
/// \param picture after bloom and vision \param pipeline all of it, also those two: the text in the PNG
/// \throws IoError if the file can't be written.
void write_contact_sheet(const std::filesystem::path& png, const Image<XYZ>& picture, const Pipeline& pipeline,
                         int threads);

/// Three exposures: see exposure_tiles(). Around the white of the pipeline's tone mapper if that is `fixed`, else
/// around a tenth of the picture's robust largest luminance. Parameters as above. \throws IoError if the file can't be
/// written.
void write_exposures(const std::filesystem::path& png, const Image<XYZ>& picture, const SceneLuminance& luminance,
                     const Pipeline& pipeline, int threads);

/// CSV: two lines of comment, then "luminance_cdm2,display_luminance" and a row for each point of tone_curve().
/// \throws IoError if the file can't be written.
void write_curve(const std::filesystem::path& csv, const Image<XYZ>& picture, const ToneMapping& mapping, int threads);

}  // namespace emulsion::cli
