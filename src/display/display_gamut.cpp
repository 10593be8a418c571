#include "display/display_gamut.h"

#include "spectrum/oklab.h"

namespace emulsion {

DisplayGamut display_gamut(const Display& display) {
    validate(display);
    const Matrix3 xyz = xyz_from_rgb(rgb_space(display));
    DisplayGamut gamut{{xyz.m[1][0], xyz.m[1][1], xyz.m[1][2]}, kOklabConesFromXyz * xyz, {}};
    for (auto& row : gamut.cones_from_rgb.m) {
        const double white = row[0] + row[1] + row[2];
        for (double& response : row) response /= white;
    }
    gamut.rgb_from_cones = inverse(gamut.cones_from_rgb);
    const auto [peak_cdm2, black_cdm2, flare_cdm2] = light_of(display);
    gamut.light_span = (peak_cdm2 - black_cdm2) / (peak_cdm2 + flare_cdm2);
    gamut.dark_light = (black_cdm2 + flare_cdm2) / (peak_cdm2 + flare_cdm2);
    return gamut;
}

}  // namespace emulsion
