#include "tonemap/varying_radius.h"

#include <utility>

#include "tonemap/scale_selection.h"

namespace emulsion {

namespace {

ScaleSelection selection_of(const VaryingRadiusAdaptation& adaptation) {
    constexpr int kWidest = 32;
    ScaleSelection selection;
    selection.limit = adaptation.contrast;
    for (int scale_px = 1; scale_px <= 2 * kWidest; scale_px *= 2) {
        selection.sigma_px.push_back(0.25 * scale_px);
        if (scale_px <= kWidest) selection.floor.push_back(0.0);
    }
    return selection;
}

}  // namespace

Image<float> local_luminance(const VaryingRadiusAdaptation& adaptation, Image<float> relative_luminance, int threads) {
    return select_scales(selection_of(adaptation), std::move(relative_luminance), threads);
}

Image<double> local_luminance_reference(const VaryingRadiusAdaptation& adaptation,
                                        const Image<double>& relative_luminance) {
    return select_scales_reference(selection_of(adaptation), relative_luminance);
}

}  // namespace emulsion
