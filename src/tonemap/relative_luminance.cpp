#include "tonemap/relative_luminance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "core/row_blocks.h"
#include "tonemap/neighbourhood_rows.h"

namespace emulsion {

namespace {

constexpr double kLargest = 0x1p119;

bool is_good(const XYZ& pixel, double least_outlier) noexcept {
    const PixelClass pixel_class = classify(pixel);
    return pixel_class == PixelClass::zero || (pixel_class == PixelClass::positive && pixel.y < least_outlier);
}

/// Between the two values in the middle, in logarithms; `values` are some, >= 0.
double log_median(std::span<double> values) noexcept {
    std::sort(values.begin(), values.end());
    return std::sqrt(values[(values.size() - 1) / 2] * values[values.size() / 2]);
}

/// Good luminances in the square about a pixel, without the pixel.
class Surround {
  public:
    Surround(ImageView<const XYZ> scene, double least_outlier) noexcept
        : scene_(scene), least_outlier_(least_outlier) {}

    void look_about(int x, int y, int radius) noexcept {
        pair_count_ = single_count_ = 0;
        for (int v = 0; v <= radius; ++v) {
            for (int u = v == 0 ? 1 : -radius; u <= radius; ++u) {
                const double one = good_or_nan(x + u, y + v), other = good_or_nan(x - u, y - v);
                if (!std::isnan(one + other)) {
                    pairs_[pair_count_++] = one;
                    pairs_[pair_count_++] = other;
                } else if (!std::isnan(one) || !std::isnan(other)) {
                    singles_[single_count_++] = std::isnan(one) ? other : one;
                }
            }
        }
    }

    /// Those that lie opposite each other: where luminance rises or falls evenly, the pixel is in the middle of them.
    [[nodiscard]] std::span<double> pairs() noexcept { return std::span(pairs_).first(pair_count_); }
    /// The others.
    [[nodiscard]] std::span<double> singles() noexcept { return std::span(singles_).first(single_count_); }

    static constexpr int kMostRadius = 4;

  private:
    [[nodiscard]] double good_or_nan(int x, int y) const noexcept {
        const bool inside = x >= 0 && x < scene_.width() && y >= 0 && y < scene_.height();
        if (!inside || !is_good(scene_(x, y), least_outlier_)) return std::numeric_limits<double>::quiet_NaN();
        return scene_(x, y).y;
    }

    static constexpr std::size_t kMost = (2 * kMostRadius + 1) * (2 * kMostRadius + 1) - 1;
    ImageView<const XYZ> scene_;
    double least_outlier_;
    std::array<double, kMost> pairs_{};
    std::array<double, kMost / 2> singles_{};
    std::size_t pair_count_ = 0, single_count_ = 0;
};

/// What stands for the pixel at x, y, in cd/m^2; 0 or more.
double stand_in(ImageView<const XYZ> scene, int x, int y, double least_outlier, double otherwise) noexcept {
    Surround surround(scene, least_outlier);
    for (int radius = 1; radius <= Surround::kMostRadius; ++radius) {
        surround.look_about(x, y, radius);
        if (!surround.pairs().empty()) return log_median(surround.pairs());
        if (!surround.singles().empty()) return log_median(surround.singles());
    }
    return otherwise;
}

/// Stands in the result for a pixel that is not good, until it is replaced.
constexpr float kMissing = -1.0f;

/// \return whether any is missing
template <class T>
bool exact_relative_row(std::span<const XYZ> in, double per_cdm2, double least_outlier, std::span<T> out) noexcept {
    bool any_missing = false;
    for (std::size_t x = 0; x < in.size(); ++x) {
        const bool here = is_good(in[x], least_outlier);
        out[x] = here ? static_cast<T>(std::min(in[x].y * per_cdm2, kLargest)) : T(kMissing);
        any_missing = any_missing || !here;
    }
    return any_missing;
}

/// In single precision where it reaches.
bool narrow_relative_row(std::span<const XYZ> in, double per_cdm2, double least_outlier, std::span<float> out) {
    if (per_cdm2 < 0x1p-100 || per_cdm2 > 0x1p100) return exact_relative_row(in, per_cdm2, least_outlier, out);
    constexpr double kInfinity = std::numeric_limits<float>::infinity();
    return relative_row(in, static_cast<float>(per_cdm2), static_cast<float>(std::min(least_outlier, kInfinity)),
                        kLargest, out);
}
bool narrow_relative_row(std::span<const XYZ> in, double per_cdm2, double least_outlier,
                         std::span<double> out) noexcept {
    return exact_relative_row(in, per_cdm2, least_outlier, out);
}

}  // namespace

template <class T>
Image<T> relative_luminance(ImageView<const XYZ> scene, const SceneLuminance& luminance, int threads) {
    const double unit = luminance.log_average_cdm2(), least_outlier = luminance.least_outlier_cdm2();
    Image<T> result(scene.width(), scene.height());
    parallel_for_rows(scene.width(), scene.height(), threads, [&](int y) {
        const std::span<T> out = result.row(y);
        if (!narrow_relative_row(scene.row(y), 1.0 / unit, least_outlier, out)) return;
        for (std::size_t x = 0; x < out.size(); ++x) {
            if (out[x] != T(kMissing)) continue;
            const double instead = stand_in(scene, static_cast<int>(x), y, least_outlier, unit);
            out[x] = static_cast<T>(std::min(instead / unit, kLargest));
        }
    });
    return result;
}

template Image<float> relative_luminance(ImageView<const XYZ>, const SceneLuminance&, int);
template Image<double> relative_luminance(ImageView<const XYZ>, const SceneLuminance&, int);

}  // namespace emulsion
