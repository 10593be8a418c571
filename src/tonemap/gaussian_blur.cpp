#include "tonemap/gaussian_blur.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "core/parallel.h"
#include "tonemap/gaussian_rows.h"
#include "tonemap/half_size.h"

namespace emulsion {

namespace {

constexpr int kBand = 32;       // rows on one thread
constexpr double kTail = 1e-4;  // bright lights spread as far as they are seen

template <class Band>
void for_each_band(int height, int threads, const Band& body) {
    parallel_for(0, (height + kBand - 1) / kBand, threads,
                 [&](int band) { body(band * kBand, std::min(height, (band + 1) * kBand)); });
}

Image<float> blur_directly(const Image<float>& source, double sigma_px, int threads) {
    Image<float> blurred(source.width(), source.height());
    for_each_band(source.height(), threads, [&](int begin, int end) {
        GaussianRows rows(source.view(), std::array{sigma_px}, kTail);
        for (int y = begin; y < end; ++y) {
            rows.compute(y);
            std::copy(rows.row(0).begin(), rows.row(0).end(), blurred.row(y).begin());
        }
    });
    return blurred;
}

Image<float> double_size(const Image<float>& half, int width, int height, int threads) {
    Image<float> whole(width, height);
    for_each_band(height, threads, [&](int begin, int end) {
        std::vector<float> scratch(static_cast<std::size_t>(half.width()) + 2);
        for (int y = begin; y < end; ++y) double_row(half.view(), y, scratch, whole.row(y));
    });
    return whole;
}

}  // namespace

Image<float> gaussian_blur(const Image<float>& source, double sigma_px, int threads) {
    // Making the picture smaller and larger again blurs, too; at least one squared pixel of variance is left to do.
    const double half_variance = 0.25 * sigma_px * sigma_px - kHalfSizeVariance - kDoubleSizeVariance;
    if (half_variance < 1.0) return blur_directly(source, sigma_px, threads);
    const Image<float> half = gaussian_blur(half_size(source.view(), threads), std::sqrt(half_variance), threads);
    return double_size(half, source.width(), source.height(), threads);
}

}  // namespace emulsion
