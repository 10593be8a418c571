#include "tonemap/scale_selection.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "core/parallel.h"
#include "tonemap/gaussian_rows.h"
#include "tonemap/half_size.h"
#include "tonemap/wide_vectors.h"

namespace emulsion {

namespace {

/// Keeps 0 / 0 away; far below any luminance that is told from black.
constexpr double kLeastFloor = 1e-36;

/// 1 where a scale is accepted, 0 where it is not. T: double, float, or a vector of floats.
template <class T>
EMULSION_INLINE inline void accept(const T& centre, const T& surround, const T& floor, const T& limit,
                                   T& acceptance) noexcept {
    const T difference = centre < surround ? surround - centre : centre - surround;
    const T left = T{} + 1.5f - difference / (limit * (floor + centre));
    const T positive = left > 0.0f ? left : T{};
    acceptance = positive < 1.0f ? positive : T{} + 1.0f;
}

/// Scales that are looked at in the picture of one size.
struct Octave {
    std::size_t first_scale = 0, end_scale = 0;
    std::vector<double> sigma_px;  ///< blurs, in its pixels: B of first_level() to end_scale
    /// Whose B is taken if the first scale is not accepted; of the very first, the first that there is.
    [[nodiscard]] std::size_t first_level() const noexcept { return first_scale == 0 ? 0 : first_scale - 1; }
};

/// The variance of a pixel, which gaussian_kernel() adds to that of its Gaussian.
constexpr double kPixelVariance = 1.0 / 12.0;

/// The pictures in which scales are looked at: their pixels' area, and the variance that they have from being made
/// smaller, in their pixels squared.
struct PictureSize {
    double pixel_area = 1.0, own_variance = 0.0;

    [[nodiscard]] PictureSize half() const noexcept {
        return {4.0 * pixel_area, 0.25 * own_variance + kHalfSizeVariance};
    }
    /// Of the Gaussian that is left to blur by for an average of `sigma_px` pixels of the whole size.
    [[nodiscard]] double remaining_variance(double sigma_px) const noexcept {
        return (sigma_px * sigma_px + kPixelVariance) / pixel_area - own_variance - kPixelVariance;
    }
};

/// From the whole size on down. A scale is looked at in the smallest picture that is not yet blurred more than the
/// narrowest average that the scale needs.
std::vector<Octave> octaves_of(const ScaleSelection& selection) {
    constexpr double kLeastVariance = 0.3;
    const std::size_t scales = selection.floor.size();
    std::vector<Octave> octaves;
    PictureSize size;
    for (std::size_t scale = 0; scale < scales; size = size.half()) {
        Octave octave{scale, scale, {}};
        const auto fits_half = [&] {
            const double narrowest = octave.end_scale == 0 ? 0.0 : selection.sigma_px[octave.end_scale - 1];
            return size.half().remaining_variance(narrowest) >= kLeastVariance;
        };
        while (octave.end_scale < scales && !fits_half()) ++octave.end_scale;
        for (std::size_t level = octave.first_level(); scale < octave.end_scale && level <= octave.end_scale; ++level) {
            octave.sigma_px.push_back(std::sqrt(std::max(size.remaining_variance(selection.sigma_px[level]), 0.0)));
        }
        scale = octave.end_scale;
        octaves.push_back(std::move(octave));
    }
    return octaves;
}

/// The rows that one scale is decided by.
struct ScaleRows {
    const float *before, *centre, *surround;
    float floor, limit;
};

/// What comes of a scale, from what comes of accepting it, in `chosen`.
template <class T>
EMULSION_INLINE inline void decide(const T& before, const T& centre, const T& surround, const ScaleRows& scale,
                                   T& chosen) noexcept {
    T acceptance;
    accept<T>(centre, surround, T{} + scale.floor, T{} + scale.limit, acceptance);
    chosen = acceptance * chosen + (1.0f - acceptance) * before;
}

/// `scales` from the widest on; `row` has what comes of accepting all of them.
void decide_row(std::span<const ScaleRows> scales, std::span<float> row) noexcept {
    with_wide_vectors([=]() EMULSION_INLINE {
        std::size_t x = 0;
        for (; x + kLanes <= row.size(); x += kLanes) {
            Floats chosen, before, centre, surround;
            load(chosen, &row[x]);
            for (const ScaleRows& scale : scales) {
                load(before, scale.before + x);
                load(centre, scale.centre + x);
                load(surround, scale.surround + x);
                decide<Floats>(before, centre, surround, scale, chosen);
            }
            store(&row[x], chosen);
        }
        for (; x < row.size(); ++x) {
            for (const ScaleRows& scale : scales) {
                decide<float>(scale.before[x], scale.centre[x], scale.surround[x], scale, row[x]);
            }
        }
    });
}

/// One row of an octave. `row` has what comes of accepting all its scales, unless there are no wider ones.
void select_in_row(const ScaleSelection& selection, const Octave& octave, std::span<const float> picture,
                   const GaussianRows& blurred, std::span<float> row) {
    const auto level = [&](std::size_t number) { return blurred.row(number - octave.first_level()).data(); };
    const bool is_last = octave.end_scale == selection.floor.size();
    if (is_last) std::copy_n(level(octave.end_scale - 1), row.size(), row.begin());
    std::vector<ScaleRows> scales;
    for (std::size_t scale = octave.end_scale; scale-- > octave.first_scale;) {
        scales.push_back({scale == 0 ? picture.data() : level(scale - 1), level(scale), level(scale + 1),
                          static_cast<float>(selection.floor[scale] + kLeastFloor),
                          static_cast<float>(selection.limit)});
    }
    decide_row(scales, row);
}

Image<float> select_in_octave(const ScaleSelection& selection, const Octave& octave, ImageView<const float> picture,
                              const Image<float>& wider, int threads) {
    constexpr int kBand = 32;       // rows on one thread
    constexpr double kTail = 1e-3;  // a smaller one brings no result closer to the twin's
    const int height = picture.height();
    Image<float> chosen(picture.width(), height);
    parallel_for(0, (height + kBand - 1) / kBand, threads, [&](int band) {
        GaussianRows blurred(picture, octave.sigma_px, kTail);
        std::vector<float> scratch(static_cast<std::size_t>(wider.width()) + 2);
        for (int y = band * kBand; y < std::min(height, (band + 1) * kBand); ++y) {
            const std::span<float> row = chosen.row(y);
            if (wider.width() > 0) double_row(wider.view(), y, scratch, row);
            blurred.compute(y);
            select_in_row(selection, octave, picture.row(y), blurred, row);
        }
    });
    return chosen;
}

}  // namespace

Image<float> select_scales(const ScaleSelection& selection, const Image<float>& luminance, int threads) {
    const std::vector<Octave> octaves = octaves_of(selection);
    std::vector<Image<float>> smaller;
    const auto picture = [&](std::size_t octave) {
        return octave == 0 ? luminance.view() : std::as_const(smaller[octave - 1]).view();
    };
    for (std::size_t octave = 1; octave < octaves.size(); ++octave) {
        smaller.push_back(half_size(picture(octave - 1), threads));
    }
    Image<float> chosen;
    for (std::size_t octave = octaves.size(); octave-- > 0;) {
        chosen = select_in_octave(selection, octaves[octave], picture(octave), chosen, threads);
        if (octave > 0) smaller.pop_back();
    }
    return chosen;
}

Image<double> select_scales_reference(const ScaleSelection& selection, const Image<double>& luminance) {
    std::vector<Image<double>> blurred;
    const std::size_t scales = selection.floor.size();
    for (std::size_t level = 0; level <= scales; ++level) {
        blurred.push_back(gaussian_blur_reference(luminance, selection.sigma_px[level]));
    }
    Image<double> result(luminance.width(), luminance.height());
    for (int y = 0; y < luminance.height(); ++y) {
        for (int x = 0; x < luminance.width(); ++x) {
            double chosen = luminance(x, y), share = 1.0, sum = 0.0;
            for (std::size_t scale = 0; scale < scales; ++scale) {
                double accepted = 0.0;
                accept(blurred[scale](x, y), blurred[scale + 1](x, y), selection.floor[scale] + kLeastFloor,
                       selection.limit, accepted);
                sum += share * (1.0 - accepted) * chosen;
                share *= accepted;
                chosen = blurred[scale](x, y);
            }
            result(x, y) = sum + share * chosen;
        }
    }
    return result;
}

}  // namespace emulsion
