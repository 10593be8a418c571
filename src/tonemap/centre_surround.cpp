#include "tonemap/centre_surround.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "tonemap/scale_selection.h"

namespace emulsion {

namespace {

ScaleSelection selection_of(const CentreSurroundAdaptation& adaptation) {
    constexpr int kScales = 8;
    constexpr double kRatio = 1.6;
    ScaleSelection selection;
    selection.limit = adaptation.epsilon;
    for (int i = 0; i <= kScales; ++i) {
        const double scale_px = std::pow(kRatio, i);
        selection.sigma_px.push_back(adaptation.alpha * scale_px / std::numbers::sqrt2);
        if (i < kScales) selection.floor.push_back(std::exp2(adaptation.phi) / (scale_px * scale_px));
    }
    return selection;
}

}  // namespace

Image<float> local_luminance(const CentreSurroundAdaptation& adaptation, Image<float> relative_luminance, int threads) {
    return select_scales(selection_of(adaptation), std::move(relative_luminance), threads);
}

Image<double> local_luminance_reference(const CentreSurroundAdaptation& adaptation,
                                        const Image<double>& relative_luminance) {
    return select_scales_reference(selection_of(adaptation), relative_luminance);
}

}  // namespace emulsion
