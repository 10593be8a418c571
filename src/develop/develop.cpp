#include "develop/develop.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "display/display_encoder.h"
#include "display/display_rgb.h"

namespace emulsion {

namespace {

XYZ narrow(const XYZd& xyz) noexcept {
    return {static_cast<float>(xyz.x), static_cast<float>(xyz.y), static_cast<float>(xyz.z)};
}

/// The three stages between tone mapping and quantization, a stretch of a row at a time while it is in the cache.
class Encoder {
  public:
    Encoder(const Image<XYZ>& display_xyz, const Pipeline& pipeline)
        : display_xyz_(display_xyz),
          conversion_(rgb_from_xyz(pipeline.display, pipeline.white)),
          mapper_(pipeline.gamut),
          gamut_(display_gamut(pipeline.display)),
          encode_(pipeline.display, transfer_of(pipeline)),
          counts_(static_cast<std::size_t>(display_xyz.height())) {}

    /// As MakeEncoded.
    void operator()(int y, int x0, std::span<RGB> pixels) {
        const std::span<const XYZ> row = display_xyz_.row(y);
        display_rgb(conversion_, row.subspan(static_cast<std::size_t>(x0), pixels.size()), pixels);
        counts_[static_cast<std::size_t>(y)] += map_gamut(mapper_, gamut_, pixels);
        encode_(pixels);
    }

    /// Of all that was encoded.
    [[nodiscard]] GamutCounts counts() const noexcept {
        GamutCounts total;
        for (const GamutCounts& row : counts_) total += row;
        return total;
    }

  private:
    const Image<XYZ>& display_xyz_;
    RgbFromXyz conversion_;
    GamutMapper mapper_;
    DisplayGamut gamut_;
    DisplayEncoder encode_;
    std::vector<GamutCounts> counts_;  // of each row
};

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
    DevelopResult result{Image<CodeRGB>(display_xyz.width(), display_xyz.height(), UnsetPixels{}), {}};
    Encoder encode(display_xyz, pipeline);
    quantize_into(pipeline.dither, std::ref(encode), code_scale(pipeline.bits, pipeline.range), result.image.view(),
                  threads);
    result.report.gamut = encode.counts();
    return result;
}

}  // namespace emulsion
