#pragma once
// The stages between tone mapping and quantization.

#include <functional>
#include <span>
#include <vector>

#include "core/color.h"
#include "develop/pipeline.h"
#include "display/display_encoder.h"
#include "display/display_gamut.h"
#include "display/display_rgb.h"
#include "display/gamut_counts.h"

namespace emulsion {

/// Writes display-relative XYZ of row y from column x0 on, as many as `pixels` takes.
using MakeDisplayXyz = std::function<void(int y, int x0, std::span<XYZ> pixels)>;

/// Display RGB, gamut mapping and transfer function of a Pipeline, by the stretch while it is in the cache.
class PictureEncoder {
  public:
    /// \throws std::invalid_argument if the pipeline's display, white or transfer function isn't valid
    PictureEncoder(int height, MakeDisplayXyz make, const Pipeline& pipeline);

    /// As MakeEncoded (display/encoded_source.h): never on two threads at a time for the same row.
    void operator()(int y, int x0, std::span<RGB> pixels);

    /// Of all that was encoded.
    [[nodiscard]] GamutCounts counts() const noexcept;

  private:
    MakeDisplayXyz make_;
    RgbFromXyz conversion_;
    GamutMapper mapper_;
    DisplayGamut gamut_;
    DisplayEncoder encode_;
    std::vector<GamutCounts> counts_;  // of each row
};

}  // namespace emulsion
