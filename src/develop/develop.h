#pragma once
// Developing a picture: scene-referred XYZ through the stages of a Pipeline to code values.

#include <optional>

#include "core/color.h"
#include "core/image.h"
#include "develop/pipeline.h"
#include "display/code_value.h"
#include "display/gamut_counts.h"
#include "tonemap/luminance_statistics.h"

namespace emulsion {

/// What was found on the way, for telling the user.
struct DevelopReport {
    LuminanceStatistics luminance;  ///< of what is tone-mapped, cd/m^2, with the counts of the scene's bad pixels
    GamutCounts gamut;              ///< pixels that the display could not show, after tone mapping
    bool operator==(const DevelopReport&) const = default;
};

struct DevelopResult {
    Image<CodeRGB> image;
    DevelopReport report;
};

/// Bloom, vision, tone mapping, display RGB, gamut mapping, transfer function, quantization with dithering.
/// Every pixel comes out defined: see tone_map() for bad ones. The same result for every number of threads (0: all).
/// The stages hand on what is in the processor's cache: besides the scene and the codes there is no picture in memory,
/// unless bloom, vision, a local operator or Hilbert order need one.
/// Under precision=reference the stages up to tone mapping are their twins in double precision, each on one thread,
/// with their pictures in memory. \param scene XYZ, Y in cd/m^2 \throws std::invalid_argument if the picture is empty,
/// the pipeline is not valid, or threads < 0.
[[nodiscard]] DevelopResult develop(const Image<XYZ>& scene, const Pipeline& pipeline, int threads);

/// The stages before tone mapping: bloom, then vision; scene-referred XYZ again. None if the pipeline has neither.
/// \throws std::invalid_argument as develop().
[[nodiscard]] std::optional<Image<XYZ>> before_tone_mapping(const Image<XYZ>& scene, const Pipeline& pipeline,
                                                            int threads);

/// Tone mapping of what before_tone_mapping() leaves. \throws std::invalid_argument as develop().
[[nodiscard]] PreparedToneMapping prepare_tone_mapping(const Pipeline& pipeline, ImageView<const XYZ> picture,
                                                       int threads);

/// The same by the tone curve of `other`, for comparing the two: PreparedToneMapping::as_other().
/// \throws std::invalid_argument as develop(), and if the sizes differ.
[[nodiscard]] PreparedToneMapping prepare_tone_mapping_as_other(const Pipeline& pipeline, ImageView<const XYZ> picture,
                                                                ImageView<const XYZ> other, int threads);

/// The stages up to tone mapping: display-relative XYZ, Y = 1 at display white.
/// \throws std::invalid_argument as develop().
[[nodiscard]] Image<XYZ> tone_mapped(const Image<XYZ>& scene, const Pipeline& pipeline, int threads);

/// The stages after tone mapping, for pictures that are tone-mapped already: display-relative XYZ, Y = 1 at display
/// white. The report's luminance is left empty. \throws std::invalid_argument as develop().
[[nodiscard]] DevelopResult develop_tone_mapped(const Image<XYZ>& display_xyz, const Pipeline& pipeline, int threads);

}  // namespace emulsion
