#include "develop/develop.h"

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "core/row_blocks.h"
#include "display/display_encoder.h"
#include "display/display_rgb.h"

namespace emulsion {

namespace {

XYZ narrow(const XYZd& xyz) noexcept {
    return {static_cast<float>(xyz.x), static_cast<float>(xyz.y), static_cast<float>(xyz.z)};
}

/// The three stages between tone mapping and quantization, row by row while the row is in the cache.
GamutCounts encode_rows(const Image<XYZ>& display_xyz, const Pipeline& pipeline, Image<RGB>& encoded, int threads) {
    const RgbFromXyz conversion = rgb_from_xyz(pipeline.display, pipeline.white);
    const DisplayGamut gamut = display_gamut(pipeline.display);
    const DisplayEncoder encode_row(pipeline.display, transfer_of(pipeline));
    std::vector<GamutCounts> counts(static_cast<std::size_t>(display_xyz.height()));
    parallel_for_rows(display_xyz.width(), display_xyz.height(), threads, [&](int y) {
        const std::span<RGB> row = encoded.row(y);
        display_rgb(conversion, display_xyz.row(y), row);
        counts[static_cast<std::size_t>(y)] = map_gamut(pipeline.gamut, gamut, row);
        encode_row(row);
    });
    GamutCounts total;
    for (const GamutCounts& row : counts) total += row;
    return total;
}

}  // namespace

std::optional<Image<XYZ>> before_tone_mapping(const Image<XYZ>& scene, const Pipeline& pipeline, int threads) {
    std::optional<Image<XYZ>> picture;
    if (!std::holds_alternative<NoBloom>(pipeline.bloom)) picture = add_bloom(pipeline.bloom, scene.view(), threads);
    if (!std::holds_alternative<NoVision>(pipeline.vision)) {
        picture = see(pipeline.vision, picture ? std::as_const(*picture).view() : scene.view(), threads);
    }
    return picture;
}

DevelopResult develop(Image<XYZ> scene, const Pipeline& pipeline, int threads) {
    validate(pipeline);
    if (std::optional<Image<XYZ>> picture = before_tone_mapping(scene, pipeline, threads)) scene = std::move(*picture);
    const LuminanceStatistics statistics =
        tone_map_into({pipeline.tone_mapper, pipeline.adaptation}, std::as_const(scene).view(), scene.view(),
                      narrow(shown_as_white(pipeline.white, pipeline.display)), threads);
    DevelopResult result = develop_tone_mapped(scene, pipeline, threads);
    result.report.luminance = statistics;
    return result;
}

DevelopResult develop_tone_mapped(const Image<XYZ>& display_xyz, const Pipeline& pipeline, int threads) {
    validate(pipeline);
    Image<RGB> encoded(display_xyz.width(), display_xyz.height());
    DevelopReport report;
    report.gamut = encode_rows(display_xyz, pipeline, encoded, threads);
    return {quantize(pipeline.dither, encoded.view(), code_scale(pipeline.bits, pipeline.range), threads), report};
}

}  // namespace emulsion
