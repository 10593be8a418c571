#include "develop/develop.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include "core/row_blocks.h"
#include "develop/picture_encoder.h"
#include "tonemap/single_precision.h"

namespace emulsion {

namespace {

XYZ white_of_tone_mapping(const Pipeline& pipeline) {
    const XYZd white = shown_as_white(pipeline.scene_white, pipeline.display);
    return {static_cast<float>(white.x), static_cast<float>(white.y), static_cast<float>(white.z)};
}

bool is_reference(const Pipeline& pipeline) noexcept {
    return std::holds_alternative<ReferencePrecision>(pipeline.precision);
}

std::optional<Image<XYZ>> before_tone_mapping_reference(const Image<XYZ>& scene, const Pipeline& pipeline) {
    std::optional<Image<XYZ>> picture;
    if (!std::holds_alternative<NoBloom>(pipeline.bloom)) {
        picture = in_single_precision(add_bloom_reference(pipeline.bloom, scene.view()));
    }
    if (!std::holds_alternative<NoVision>(pipeline.vision)) {
        const ImageView<const XYZ> bloomed = picture ? std::as_const(*picture).view() : scene.view();
        picture = in_single_precision(see_reference(pipeline.vision, bloomed));
    }
    return picture;
}

DevelopResult encode_and_quantize(int width, int height, MakeDisplayXyz make, const Pipeline& pipeline, int threads) {
    DevelopResult result{Image<CodeRGB>(width, height, UnsetPixels{}), {}};
    PictureEncoder encode(height, std::move(make), pipeline);
    quantize_into(pipeline.dither, std::ref(encode), code_scale(pipeline.bits, pipeline.range), result.image.view(),
                  threads);
    result.report.gamut = encode.counts();
    return result;
}

}  // namespace

std::optional<Image<XYZ>> before_tone_mapping(const Image<XYZ>& scene, const Pipeline& pipeline, int threads) {
    if (is_reference(pipeline)) return before_tone_mapping_reference(scene, pipeline);
    std::optional<Image<XYZ>> picture;
    if (!std::holds_alternative<NoBloom>(pipeline.bloom)) picture = add_bloom(pipeline.bloom, scene.view(), threads);
    if (!std::holds_alternative<NoVision>(pipeline.vision)) {
        picture = see(pipeline.vision, picture ? std::as_const(*picture).view() : scene.view(), threads);
    }
    return picture;
}

PreparedToneMapping prepare_tone_mapping(const Pipeline& pipeline, ImageView<const XYZ> picture, int threads) {
    const ToneMapping mapping{pipeline.tone_mapper, pipeline.adaptation};
    const XYZ white = white_of_tone_mapping(pipeline);
    if (is_reference(pipeline)) return PreparedToneMapping::reference(mapping, picture, white);
    return {mapping, picture, white, threads};
}

PreparedToneMapping prepare_tone_mapping_as_other(const Pipeline& pipeline, ImageView<const XYZ> picture,
                                                  ImageView<const XYZ> other, int threads) {
    const ToneMapping mapping{pipeline.tone_mapper, pipeline.adaptation};
    const XYZ white = white_of_tone_mapping(pipeline);
    if (is_reference(pipeline)) return PreparedToneMapping::reference_as_other(mapping, picture, other, white);
    return PreparedToneMapping::as_other(mapping, picture, other, white, threads);
}

DevelopResult develop(const Image<XYZ>& scene, const Pipeline& pipeline, int threads) {
    validate(pipeline);
    const std::optional<Image<XYZ>> before = before_tone_mapping(scene, pipeline, threads);
    const ImageView<const XYZ> picture = before ? before->view() : scene.view();
    const PreparedToneMapping map = prepare_tone_mapping(pipeline, picture, threads);
    DevelopResult result = encode_and_quantize(picture.width(), picture.height(), std::cref(map), pipeline, threads);
    result.report.luminance = map.statistics();
    return result;
}

Image<XYZ> tone_mapped(const Image<XYZ>& scene, const Pipeline& pipeline, int threads) {
    validate(pipeline);
    const std::optional<Image<XYZ>> before = before_tone_mapping(scene, pipeline, threads);
    const PreparedToneMapping map = prepare_tone_mapping(pipeline, (before ? *before : scene).view(), threads);
    Image<XYZ> display(scene.width(), scene.height(), UnsetPixels{});
    parallel_for_rows(scene.width(), scene.height(), threads, [&](int y) { map(y, 0, display.row(y)); });
    return display;
}

DevelopResult develop_tone_mapped(const Image<XYZ>& display_xyz, const Pipeline& pipeline, int threads) {
    validate(pipeline);
    const auto read = [&](int y, int x0, std::span<XYZ> pixels) {
        std::ranges::copy(display_xyz.row(y).subspan(static_cast<std::size_t>(x0), pixels.size()), pixels.begin());
    };
    return encode_and_quantize(display_xyz.width(), display_xyz.height(), read, pipeline, threads);
}

}  // namespace emulsion
