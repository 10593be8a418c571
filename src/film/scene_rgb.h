#pragma once
// What the formats that hold bare linear RGB share: to it, and what is said when it is read.

#include <stdexcept>

#include "core/matrix3.h"
#include "core/parameters.h"
#include "film/scene_picture.h"
#include "spectrum/rgb_space.h"

namespace emulsion {

inline constexpr const char* kNoPrimariesNote = "no primaries: taken as Rec. 709 with the white D65";
inline constexpr const char* kNoWhiteLuminanceNote = "no white luminance: 1 taken as 1 cd/m^2";

/// From XYZ, Y in cd/m^2, to the RGB of SceneWriteOptions, in double precision and rounded once.
class SceneRgb {
  public:
    /// \throws std::invalid_argument if the picture is empty or the white luminance out of its range.
    SceneRgb(const Image<XYZ>& picture, const SceneWriteOptions& options)
        : rgb_from_xyz_(rgb_from_xyz(rgb_space("Rec709"))), scale_(1.0 / options.white_luminance_cdm2) {
        if (picture.width() < 1) throw std::invalid_argument("picture: is empty, expected pixels");
        check_range(options.white_luminance_cdm2, {1e-30, 1e30}, "white_luminance_cdm2");
    }
    [[nodiscard]] RGB operator()(const XYZ& xyz) const noexcept {
        const auto rgb = rgb_from_xyz_ * std::array{scale_ * xyz.x, scale_ * xyz.y, scale_ * xyz.z};
        return {static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2])};
    }

  private:
    Matrix3 rgb_from_xyz_;
    double scale_;
};

}  // namespace emulsion
