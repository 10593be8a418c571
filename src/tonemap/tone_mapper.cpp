#include "tonemap/tone_mapper.h"

#include <stdexcept>
#include <string>

#include "tonemap/scale_pixels.h"

namespace emulsion {

namespace {

std::string size_text(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

void check(const ToneMapper& mapper, ImageView<const XYZ> scene) {
    validate_named(mapper, "tonemap");
    if (scene.width() >= 1 && scene.height() >= 1) return;
    throw std::invalid_argument("scene size " + size_text(scene.width(), scene.height()) + ": both must be at least 1");
}

}  // namespace

LuminanceStatistics tone_map_into(const ToneMapper& mapper, ImageView<const XYZ> scene, ImageView<XYZ> display,
                                  const XYZ& display_white, int threads) {
    check(mapper, scene);
    if (display.width() != scene.width() || display.height() != scene.height()) {
        throw std::invalid_argument("display size " + size_text(display.width(), display.height()) + ": must be " +
                                    size_text(scene.width(), scene.height()) + ", as the scene's");
    }
    const LuminanceStatistics statistics = luminance_statistics(scene, threads);
    std::visit([&](const auto& chosen) { apply(chosen, statistics, scene, display, display_white, threads); }, mapper);
    return statistics;
}

ToneMapResult tone_map(const ToneMapper& mapper, ImageView<const XYZ> scene, const XYZ& display_white, int threads) {
    check(mapper, scene);
    ToneMapResult result{Image<XYZ>(scene.width(), scene.height()), {}};
    result.statistics = tone_map_into(mapper, scene, result.image.view(), display_white, threads);
    return result;
}

Image<XYZd> tone_map_reference(const ToneMapper& mapper, ImageView<const XYZ> scene, const XYZd& display_white) {
    check(mapper, scene);
    const LuminanceStatistics statistics = luminance_statistics_reference(scene);
    const auto scale = [&](double luminance_cdm2) {
        return std::visit([&](const auto& chosen) { return luminance_scale(chosen, statistics, luminance_cdm2); },
                          mapper);
    };
    Image<XYZd> display(scene.width(), scene.height());
    for (int y = 0; y < scene.height(); ++y) {
        for (int x = 0; x < scene.width(); ++x) display(x, y) = scaled_pixel(scene(x, y), display_white, scale);
    }
    return display;
}

}  // namespace emulsion
