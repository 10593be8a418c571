#include "film/rgb_input.h"

#include <cstddef>

#include "core/parameters.h"
#include "film/sensor_options.h"

namespace emulsion {

RgbInput::RgbInput(const RgbSpace& space, double imaging_ratio, double white_luminance_cdm2)
    : exact_(xyz_from_rgb(space)) {
    check_range(imaging_ratio, {kMinImagingRatio, kMaxImagingRatio}, "RGB input: imaging_ratio");
    check_range(white_luminance_cdm2, {kMinImagingRatio, kMaxImagingRatio}, "RGB input: white_luminance_cdm2");
    check_range(white_luminance_cdm2 * imaging_ratio, {kMinImagingRatio, kMaxImagingRatio},
                "RGB input: white_luminance_cdm2 * imaging_ratio");
    std::size_t i = 0;
    for (auto& row : exact_.m) {
        for (double& entry : row) {
            entry *= white_luminance_cdm2 * imaging_ratio;
            xyz_from_rgb_[i++] = static_cast<float>(entry);
        }
    }
}

XYZd RgbInput::to_xyz_reference(const RGBd& rgb) const noexcept {
    const std::array<double, 3> xyz = exact_ * std::array<double, 3>{rgb.r, rgb.g, rgb.b};
    return {xyz[0], xyz[1], xyz[2]};
}

}  // namespace emulsion
