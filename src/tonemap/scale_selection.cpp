#include "tonemap/scale_selection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "tonemap/axis_halving.h"
#include "tonemap/change_rows.h"
#include "tonemap/gaussian_rows.h"
#include "tonemap/half_size.h"
#include "tonemap/neighbourhood_rows.h"

namespace emulsion {

namespace {

/// Keeps 0 / 0 away; far below any luminance that is told from black.
constexpr double kLeastFloor = 1e-36;

/// 1 where a scale is accepted, 0 where it is not.
double accept(double centre, double surround, double floor, double limit) noexcept {
    return std::clamp(1.5 - std::abs(centre - surround) / (limit * (floor + centre)), 0.0, 1.0);
}

/// Scales that are looked at in the picture of one size.
struct Octave {
    LevelAxis x, y;
    std::size_t first_scale = 0, end_scale = 0;
    std::vector<GaussianSigma> sigmas = {};  ///< blurs, in its pixels: B of first_level() and following ones

    /// Whose B is taken if the first scale is not accepted; of the very first, the first that there is.
    [[nodiscard]] std::size_t first_level() const noexcept { return first_scale == 0 ? 0 : first_scale - 1; }
};

/// Whether a picture is not yet blurred more than it is to be.
bool fits(const LevelAxis& axis, double sigma_px) noexcept {
    constexpr double kLeastVariance = 0.3;
    return axis.halving.size() == 1 || axis.remaining_variance(sigma_px) >= kLeastVariance;
}

GaussianSigma remaining_sigma(const Octave& octave, double sigma_px) noexcept {
    const auto remaining = [&](const LevelAxis& axis) {
        return std::sqrt(std::max(axis.remaining_variance(sigma_px), 0.0));
    };
    return {remaining(octave.x), remaining(octave.y)};
}

/// From the whole size on down. A scale is looked at in the smallest picture in which the narrowest average that the
/// scale needs fits. The two widest averages of each octave come from the next, which needs them, too.
std::vector<Octave> octaves_of(const ScaleSelection& selection, int width, int height) {
    const std::size_t scales = selection.floor.size();
    std::vector<Octave> octaves = {{LevelAxis(width), LevelAxis(height)}};
    while (true) {
        Octave& octave = octaves.back();
        const Octave half{octave.x.next(), octave.y.next()};
        const bool is_dot = octave.x.halving.size() == 1 && octave.y.halving.size() == 1;
        const auto fits_half = [&] {
            if (octave.end_scale == 0 || is_dot) return false;
            const double narrowest = selection.sigma_px[octave.end_scale - 1];
            return fits(half.x, narrowest) && fits(half.y, narrowest);
        };
        while (octave.end_scale < scales && !fits_half()) ++octave.end_scale;
        const bool is_last = octave.end_scale == scales;
        const std::size_t end_level = is_last ? scales + 1 : octave.end_scale - 1;
        for (std::size_t level = octave.first_level(); level < end_level; ++level) {
            octave.sigmas.push_back(remaining_sigma(octave, selection.sigma_px[level]));
        }
        if (is_last) return octaves;
        const std::size_t end_scale = octave.end_scale;
        octaves.push_back(half);
        octaves.back().first_scale = octaves.back().end_scale = end_scale;
    }
}

/// What comes of an octave and all smaller ones: the averages that were chosen, and those of its first two levels.
struct Selected {
    Image<float> chosen;
    std::array<Image<float>, 2> levels;
};

/// One band of rows of an octave.
class OctaveRows {
  public:
    /// \param smaller of the next octave, if there is one \param result where the first two levels go, unless empty
    OctaveRows(const ScaleSelection& selection, const Octave& octave, const Selected& smaller, Selected& result)
        : selection_(selection),
          octave_(octave),
          smaller_(smaller),
          result_(result),
          blurred_(octave.x.halving.size(), octave.sigmas, kTail),
          wide_(smaller.chosen.width() == 0 ? Image<float>() : Image<float>(octave.x.halving.size(), 2)),
          scratch_(static_cast<std::size_t>(octave.x.halving.half_size()) + 2) {}

    static constexpr double kTail = 1e-3;  // a smaller one brings no result closer to the twin's

    /// \param rows of the picture about row y, which becomes what is chosen
    void select(int y, std::span<const float* const> rows);

  private:
    /// The row of the level of a number.
    [[nodiscard]] std::span<const float> level(std::size_t number) const noexcept {
        const std::size_t blurred = octave_.sigmas.size(), here = number - octave_.first_level();
        return here < blurred ? blurred_.row(here) : wide_.row(static_cast<int>(here - blurred));
    }
    void decide(const float* picture, std::span<float> row);

    const ScaleSelection& selection_;
    const Octave& octave_;
    const Selected& smaller_;
    Selected& result_;
    GaussianRows blurred_;
    Image<float> wide_;  ///< a row of each of the two levels that come from the next octave
    std::vector<float> scratch_;
    std::vector<ScaleRows> scales_;
};

void OctaveRows::select(int y, std::span<const float* const> rows) {
    const std::span<float> row = result_.chosen.row(y);
    blurred_.compute(rows);
    if (smaller_.chosen.width() == 0) {
        const std::span<const float> widest = level(octave_.end_scale - 1);
        std::copy(widest.begin(), widest.end(), row.begin());
    } else {
        const AxisHalving &across = octave_.x.halving, &down = octave_.y.halving;
        double_size_row(smaller_.chosen, across, down, y, scratch_, row);
        for (int i = 0; i < 2; ++i) {
            double_size_row(smaller_.levels[static_cast<std::size_t>(i)], across, down, y, scratch_, wide_.row(i));
        }
    }
    decide(rows[rows.size() / 2], row);
    for (std::size_t i = 0; i < result_.levels.size() && result_.levels[i].width() > 0; ++i) {
        const std::span<const float> from = level(octave_.first_level() + i);
        std::copy(from.begin(), from.end(), result_.levels[i].row(y).begin());
    }
}

/// `row` has what comes of accepting all the octave's scales.
void OctaveRows::decide(const float* picture, std::span<float> row) {
    scales_.clear();
    for (std::size_t scale = octave_.end_scale; scale-- > octave_.first_scale;) {
        scales_.push_back({scale == 0 ? picture : level(scale - 1).data(), level(scale).data(), level(scale + 1).data(),
                           static_cast<float>(selection_.floor[scale] + kLeastFloor),
                           static_cast<float>(selection_.limit)});
    }
    decide_row(scales_, row);
}

/// `picture` becomes what is chosen.
Selected select_in_octave(const ScaleSelection& selection, const Octave& octave, Image<float> picture,
                          const Selected& smaller, int threads) {
    Selected result{std::move(picture), {}};
    if (octave.first_scale > 0) {
        for (Image<float>& level : result.levels) level = Image<float>(result.chosen.width(), result.chosen.height());
    }
    const int radius = GaussianRows(1, octave.sigmas, OctaveRows::kTail).radius();
    change_rows(result.chosen, radius, threads, [&] {
        return [rows = OctaveRows(selection, octave, smaller, result)](
                   int y, std::span<const float* const> about) mutable { rows.select(y, about); };
    });
    return result;
}

}  // namespace

Image<float> select_scales(const ScaleSelection& selection, Image<float> luminance, int threads) {
    const std::vector<Octave> octaves = octaves_of(selection, luminance.width(), luminance.height());
    std::vector<Image<float>> pictures;
    pictures.push_back(std::move(luminance));
    for (std::size_t i = 0; i + 1 < octaves.size(); ++i) {
        pictures.push_back(half_size(pictures[i], octaves[i].x.halving, octaves[i].y.halving, threads));
    }
    Selected selected;
    for (std::size_t i = octaves.size(); i-- > 0;) {
        selected = select_in_octave(selection, octaves[i], std::move(pictures[i]), selected, threads);
    }
    return std::move(selected.chosen);
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
                const double accepted = accept(blurred[scale](x, y), blurred[scale + 1](x, y),
                                               selection.floor[scale] + kLeastFloor, selection.limit);
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
