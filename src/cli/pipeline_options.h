#pragma once
// The flags for the chain from XYZ to code values, shared by `render`, `merge` and `develop`.

#include <filesystem>
#include <string_view>
#include <vector>

#include "core/color.h"
#include "core/image.h"
#include "develop/develop.h"
#include "develop/pipeline.h"
#include "display/code_value.h"
#include "display/png_file.h"
#include "tonemap/luminance_statistics.h"

namespace CLI {
class App;
}

namespace emulsion::cli {

/// Adds --pipeline alone; `what` begins its help. It sets the pipeline before the flags of single stages do, wherever
/// they stand, if it is added before them.
void add_pipeline_text_option(CLI::App& command, Pipeline& pipeline, std::string_view what);

/// Adds --pipeline, for all stages at once: the text form, or a file that holds it; and --bloom, --vision, --tonemap
/// and
/// --adaptation, which go before it. Parsing sets `pipeline`, and refuses what is no such value with bad usage.
void add_pipeline_options(CLI::App& command, Pipeline& pipeline);

/// Adds the flags of the other stages likewise, after these: --scene-white, --display, and its --primaries and --white,
/// --gamut, --transfer, and its --transfer-table, --bits, --range and --dither.
void add_display_options(CLI::App& command, Pipeline& pipeline);

/// That the stages go together. \throws CLI::ValidationError if not.
void check_together(const Pipeline& pipeline);
/// And that a PNG can say what its codes mean.
void check_for_png(const Pipeline& pipeline);

/// Warns of bad pixels, if there are any: how many of each kind, and where the first is.
void warn_of_bad_pixels(const LuminanceStatistics& statistics);

/// Of a PNG that the pipeline makes: bits, and what its codes mean; no text but that we wrote it.
/// \param level of compression: display/png_compression.h
[[nodiscard]] PngOptions png_options(const Pipeline& pipeline, int level = kDefaultPngLevel);

/// Writes a developed picture as a PNG, with the pipeline that made it as text in it.
/// \param png_level of compression: display/png_compression.h \param more text of the PNG
/// \throws IoError if the file can't be written.
void write_developed(const std::filesystem::path& png, const Image<CodeRGB>& image, const Pipeline& pipeline,
                     int png_level = kDefaultPngLevel, const std::vector<PngText>& more = {});

/// Prints how many pixels the display could not show, and by how much, if there are any.
void report_gamut(const DevelopResult& developed, const Pipeline& pipeline);

/// Develops scene-referred XYZ and writes the PNG; warns of bad pixels.
/// \throws IoError if the file can't be written.
DevelopResult develop_to_png(const Image<XYZ>& scene, const Pipeline& pipeline, int threads,
                             const std::filesystem::path& png);

}  // namespace emulsion::cli
