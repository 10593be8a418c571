#include "develop/develop.h"

#include <algorithm>
#include <array>
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

/// Writes display-relative XYZ of row y from column x0 on, as many as `pixels` takes.
using MakeDisplayXyz = std::function<void(int y, int x0, std::span<XYZ> pixels)>;

/// The stages between scene and quantization, a stretch of a row at a time while it is in the cache.
class Encoder {
  public:
    Encoder(int height, MakeDisplayXyz make, const Pipeline& pipeline)
        : make_(std::move(make)),
          conversion_(rgb_from_xyz(pipeline.display, pipeline.white)),
          mapper_(pipeline.gamut),
          gamut_(display_gamut(pipeline.display)),
          encode_(pipeline.display, transfer_of(pipeline)),
          counts_(static_cast<std::size_t>(height)) {}

    /// As MakeEncoded.
    void operator()(int y, int x0, std::span<RGB> pixels) {
        std::array<XYZ, kStretch_px> room;
        while (!pixels.empty()) {
            const std::span<XYZ> display = std::span(room).first(std::min(room.size(), pixels.size()));
            const std::span<RGB> encoded = pixels.first(display.size());
            make_(y, x0, display);
            display_rgb(conversion_, display, encoded);
            GamutCounts& counts = counts_[static_cast<std::size_t>(y)];
            counts += map_gamut(mapper_, gamut_, encoded);
            counts.uncoded += encode_(encoded);
            pixels = pixels.subspan(encoded.size());
            x0 += static_cast<int>(encoded.size());
        }
    }

    /// Of all that was encoded.
    [[nodiscard]] GamutCounts counts() const noexcept {
        GamutCounts total;
        for (const GamutCounts& row : counts_) total += row;
        return total;
    }

  private:
    MakeDisplayXyz make_;
    RgbFromXyz conversion_;
    GamutMapper mapper_;
    DisplayGamut gamut_;
    DisplayEncoder encode_;
    std::vector<GamutCounts> counts_;  // of each row
};

DevelopResult encode_and_quantize(int width, int height, MakeDisplayXyz make, const Pipeline& pipeline, int threads) {
    DevelopResult result{Image<CodeRGB>(width, height, UnsetPixels{}), {}};
    Encoder encode(height, std::move(make), pipeline);
    quantize_into(pipeline.dither, std::ref(encode), code_scale(pipeline.bits, pipeline.range), result.image.view(),
                  threads);
    result.report.gamut = encode.counts();
    return result;
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

DevelopResult develop(const Image<XYZ>& scene, const Pipeline& pipeline, int threads) {
    validate(pipeline);
    const std::optional<Image<XYZ>> before = before_tone_mapping(scene, pipeline, threads);
    const ImageView<const XYZ> picture = before ? before->view() : scene.view();
    const PreparedToneMapping map({pipeline.tone_mapper, pipeline.adaptation}, picture,
                                  narrow(shown_as_white(pipeline.white, pipeline.display)), threads);
    DevelopResult result = encode_and_quantize(picture.width(), picture.height(), std::cref(map), pipeline, threads);
    result.report.luminance = map.statistics();
    return result;
}

DevelopResult develop_tone_mapped(const Image<XYZ>& display_xyz, const Pipeline& pipeline, int threads) {
    validate(pipeline);
    const auto read = [&](int y, int x0, std::span<XYZ> pixels) {
        std::ranges::copy(display_xyz.row(y).subspan(static_cast<std::size_t>(x0), pixels.size()), pixels.begin());
    };
    return encode_and_quantize(display_xyz.width(), display_xyz.height(), read, pipeline, threads);
}

}  // namespace emulsion
