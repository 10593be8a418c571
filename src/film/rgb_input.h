#pragma once
// Samples of RGB renderers: from linear RGB of a stated space to what a film's tiles take.

#include <array>

#include "core/color.h"
#include "spectrum/rgb_space.h"

namespace emulsion {

/// XYZ = white luminance * imaging ratio * M_space RGB, so that RGB (1, 1, 1) is the white of the space with that
/// luminance. Nothing is adapted: a film in XYZ keeps the white that the renderer worked with.
class RgbInput {
  public:
    /// `imaging_ratio` is that of the film's sensor: film.sensor().imaging_ratio().
    /// \throws std::invalid_argument if the space's primaries lie on one line, and for a white luminance, an
    /// imaging ratio or a product of both outside [1e-30, 1e30].
    explicit RgbInput(const RgbSpace& space, double imaging_ratio = 1.0, double white_luminance_cdm2 = 1.0);

    /// In single precision: agrees with to_xyz_reference() to 4e-7 of the sum of all terms taken positive.
    [[nodiscard]] XYZ to_xyz(const RGB& rgb) const noexcept {
        const auto& m = xyz_from_rgb_;
        return {m[0] * rgb.r + m[1] * rgb.g + m[2] * rgb.b,  //
                m[3] * rgb.r + m[4] * rgb.g + m[5] * rgb.b,  //
                m[6] * rgb.r + m[7] * rgb.g + m[8] * rgb.b};
    }
    /// The same in double precision.
    [[nodiscard]] XYZd to_xyz_reference(const RGBd& rgb) const noexcept;

  private:
    Matrix3 exact_;
    std::array<float, 9> xyz_from_rgb_{};
};

}  // namespace emulsion
