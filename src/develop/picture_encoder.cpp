#include "develop/picture_encoder.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "display/encoded_source.h"

namespace emulsion {

PictureEncoder::PictureEncoder(int height, MakeDisplayXyz make, const Pipeline& pipeline)
    : make_(std::move(make)),
      conversion_(rgb_from_xyz(pipeline.display, pipeline.scene_white)),
      mapper_(pipeline.gamut),
      gamut_(display_gamut(pipeline.display)),
      encode_(pipeline.display, transfer_of(pipeline)),
      counts_(static_cast<std::size_t>(height)) {}

void PictureEncoder::operator()(int y, int x0, std::span<RGB> pixels) {
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

GamutCounts PictureEncoder::counts() const noexcept {
    GamutCounts total;
    for (const GamutCounts& row : counts_) total += row;
    return total;
}

}  // namespace emulsion
