#include "tonemap/rod_vision.h"

#include <algorithm>

#include "core/row_blocks.h"
#include "tonemap/pixel_class.h"

namespace emulsion {

double scotopic_luminance(const XYZd& xyz) noexcept {
    constexpr double kMostRatio = 10.0;
    const double ratio = xyz.x > 0.0 ? 1.33 * (1.0 + (xyz.y + xyz.z) / xyz.x) - 1.68 : kMostRatio;
    return xyz.y * std::clamp(ratio, 0.0, kMostRatio);
}

double cone_share(double luminance_cdm2) noexcept {
    constexpr double kRange = kMostMesopic_cdm2 - kLeastMesopic_cdm2;
    return std::clamp((luminance_cdm2 - kLeastMesopic_cdm2) / kRange, 0.0, 1.0);
}

XYZd seen_with_rods(const XYZd& xyz, const RodVision& rods) noexcept {
    constexpr double kScotopicOfWhite = 1.33 * 3.0 - 1.68;
    const double rod_share = rods.weight * (1.0 - cone_share(xyz.y));
    if (rod_share == 0.0) return xyz;
    const double grey = rod_share * scotopic_luminance(xyz) / kScotopicOfWhite;
    return (1.0 - rod_share) * xyz + grey * XYZd{1.0, 1.0, 1.0 + rods.blue_shift};
}

void see_with_rods(ImageView<XYZ> picture, const RodVision& rods, int threads) {
    parallel_for_rows(picture.width(), picture.height(), threads, [&](int y) {
        for (XYZ& pixel : picture.row(y)) {
            if (pixel.y >= kMostMesopic_cdm2 || is_bad(classify(pixel))) continue;
            const XYZd seen = seen_with_rods({pixel.x, pixel.y, pixel.z}, rods);
            pixel = {static_cast<float>(seen.x), static_cast<float>(seen.y), static_cast<float>(seen.z)};
        }
    });
}

}  // namespace emulsion
