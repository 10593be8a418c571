#include "tonemap/uniform_radius.h"

#include <algorithm>
#include <utility>

#include "tonemap/gaussian_blur.h"
#include "tonemap/gaussian_rows.h"

namespace emulsion {

namespace {

template <class T>
double sigma_px(const UniformRadiusAdaptation& adaptation, const Image<T>& picture) noexcept {
    return 0.5 * double{adaptation.radius} * std::min(picture.width(), picture.height());
}

}  // namespace

Image<float> local_luminance(const UniformRadiusAdaptation& adaptation, Image<float> relative_luminance, int threads) {
    const double sigma = sigma_px(adaptation, relative_luminance);
    return gaussian_blur(std::move(relative_luminance), sigma, threads);
}

Image<double> local_luminance_reference(const UniformRadiusAdaptation& adaptation,
                                        const Image<double>& relative_luminance) {
    return gaussian_blur_reference(relative_luminance, sigma_px(adaptation, relative_luminance));
}

}  // namespace emulsion
