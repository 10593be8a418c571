#pragma once
// A picture of pictures: one tile for each of some tone mappings, for choosing by eye.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/color.h"
#include "core/image.h"
#include "develop/pipeline.h"
#include "display/code_value.h"
#include "tonemap/tone_mapper.h"

namespace emulsion {

struct ContactTile {
    ToneMapping mapping;
    std::string label;
};

/// Every operator of the variant with its defaults, in its order, under its name; adapted to what is given, or else
/// each to its own.
[[nodiscard]] std::vector<ContactTile> operator_tiles(const std::optional<Adaptation>& adaptation = std::nullopt);

/// The strip of three exposures: `fixed` with ten times the given luminance as its white, with that luminance, and with
/// a tenth of it.
/// \throws std::invalid_argument if white_cdm2 is not in [1e-30, 1e30].
[[nodiscard]] std::vector<ContactTile> exposure_tiles(double white_cdm2);

/// Row by row, up to four tiles in one row, each with its label below. Tone mappings see the whole picture; what they
/// made is then averaged down to at most `tile_px` pixels in width and in height. The other stages are those of the
/// pipeline, whose own tone mapper and adaptation are not used.
/// \param tiles one or more \param tile_px 16 to 4096
/// \throws std::invalid_argument if the picture is empty, pipeline or a tone mapping not valid, there are no tiles,
/// tile_px is out of range or threads < 0.
[[nodiscard]] Image<CodeRGB> contact_sheet(const Image<XYZ>& scene, const Pipeline& pipeline,
                                           std::span<const ContactTile> tiles, int tile_px, int threads);

}  // namespace emulsion
