#include "pathtracer/stopping_rule.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <variant>

#include "core/parallel.h"
#include "core/row_blocks.h"
#include "pathtracer/film_in_progress.h"
#include "spectrum/ciede2000_difference.h"
#include "spectrum/viewing_conditions.h"

namespace emulsion {

namespace {

FilmOptions of_noise_pair(FilmOptions film) {
    film.variance = FilmVariance::none;
    film.spectrum.reset();
    film.aux.clear();
    if (std::holds_alternative<MedianOfMeans>(film.firefly_control)) film.firefly_control = NoFireflyControl{};
    return film;
}

/// Colours are taken from squares of 2 * 3 + 1 pixels.
constexpr int kAround_px = 3;

XYZd in_double(const XYZ& xyz) noexcept { return {xyz.x, xyz.y, xyz.z}; }

/// The mean over the square around each pixel, as far as there is a picture.
Image<XYZd> mean_around(const Image<XYZ>& first, const Image<XYZ>& second, int threads) {
    Image<XYZd> mean(first.width(), first.height());
    parallel_for_rows(first.width(), first.height(), threads, [&](int y) {
        const int y0 = std::max(0, y - kAround_px), y1 = std::min(first.height(), y + kAround_px + 1);
        for (int x = 0; x < first.width(); ++x) {
            const int x0 = std::max(0, x - kAround_px), x1 = std::min(first.width(), x + kAround_px + 1);
            XYZd sum{};
            for (int v = y0; v < y1; ++v) {
                for (int u = x0; u < x1; ++u) sum = sum + in_double(first(u, v)) + in_double(second(u, v));
            }
            mean(x, y) = 0.5 / (static_cast<double>(x1 - x0) * (y1 - y0)) * sum;
        }
    });
    return mean;
}

ViewingConditions viewing_of(const Image<XYZd>& picture, const Observer& observer) {
    double sum = 0.0;
    std::int64_t positive = 0;
    for (const XYZd& pixel : picture.pixels()) {
        if (!(pixel.y > 0.0)) continue;
        sum += std::log(pixel.y);
        ++positive;
    }
    ViewingConditions viewing{.white = default_white(observer)};
    if (positive == 0) return viewing;
    const double white = white_luminance_of_log_average(std::exp(sum / static_cast<double>(positive)));
    viewing.white_luminance_cdm2 = std::clamp(white, 1e-30, 1e30);
    return viewing;
}

/// Three vectors whose products with themselves add up to this covariance (Cholesky's, by columns).
std::array<XYZd, 3> root_of(const std::array<double, 6>& covariance) noexcept {
    const auto [xx, xy, xz, yy, yz, zz] = covariance;
    const auto over = [](double value, double by) { return by > 0.0 ? value / by : 0.0; };
    const double x = std::sqrt(std::max(0.0, xx)), xy_x = over(xy, x), xz_x = over(xz, x);
    const double y = std::sqrt(std::max(0.0, yy - xy_x * xy_x)), yz_y = over(yz - xy_x * xz_x, y);
    const double z = std::sqrt(std::max(0.0, zz - xz_x * xz_x - yz_y * yz_y));
    return {{{x, xy_x, xz_x}, {0.0, y, yz_y}, {0.0, 0.0, z}}};
}

/// Mean square CIEDE2000 of a pixel of this colour under such noise. Half of what lies between an error and its
/// opposite is what the error is where the scale is even, and stays defined where it is not.
double squared_error(const XYZd& colour, const std::array<XYZd, 3>& relative_noise, const ViewingConditions& viewing) {
    double sum = 0.0;
    for (const XYZd& part : relative_noise) {
        const XYZd error = colour.y * part;
        const double across = difference(Ciede2000Difference{}, lab_as_viewed(colour + error, viewing),
                                         lab_as_viewed(colour + -1.0 * error, viewing));
        sum += 0.25 * across * across;
    }
    return sum;
}

}  // namespace

void validate_stopping(const FilmOptions& film, double target) {
    if (!(std::isfinite(target) && target > 0.0)) {
        std::ostringstream text;
        text << "until " << target << ": must be a standard error of colour, CIEDE2000, in (0, inf)";
        throw std::invalid_argument(text.str());
    }
    if (film.filter_use == FilterUse::splatted) {
        throw std::invalid_argument(
            "filter_use splatted: must be importance_sampled where tiles stop on their own, or the samples of the tile "
            "that has more outweigh its neighbour's at their edge");
    }
}

StoppingRule::StoppingRule(const FilmOptions& film, double target, int tile_px)
    : first_((validate_stopping(film, target), of_noise_pair(film))),
      second_(of_noise_pair(film)),
      target_(target),
      tile_px_(tile_px),
      stopped_(tile_count(first_.sample_bounds(), tile_px)),
      noise_(stopped_.size()) {}

std::uint64_t StoppingRule::look_after(std::uint64_t picture_samples) noexcept {
    const std::uint64_t share = picture_samples / kShareOfLook;
    return picture_samples + std::max(kSamplesPerLook, share - share % kSamplesPerLook);
}

std::uint64_t StoppingRule::pair_samples(std::uint64_t picture_samples) noexcept {
    return std::max(kFewestPairSamples, picture_samples / kSamplesPerPairSample);
}

PixelBounds StoppingRule::pixels_of(std::size_t tile) const noexcept {
    const PixelBounds& places = first_.sample_bounds();  // of importance sampled filters, the film's pixels
    const PixelBounds bounds = tile_bounds(places, tile_px_, tile);
    return {bounds.x0 - places.x0, bounds.y0 - places.y0, bounds.x1 - places.x0, bounds.y1 - places.y0};
}

StoppingRule::Pair StoppingRule::shown(int threads) const {
    const Image<XYZ> first = first_.xyz_image(), second = second_.xyz_image();
    Pair pair{mean_around(first, second, threads), Image<XYZd>(first.width(), first.height())};
    for (std::size_t i = 0; i < first.pixels().size(); ++i) {
        pair.error.pixels()[i] = 0.5 * (in_double(first.pixels()[i]) + -1.0 * in_double(second.pixels()[i]));
    }
    return pair;
}

void StoppingRule::measure(std::size_t tile, const Pair& pair, std::uint64_t samples_of_both) {
    Noise noise;
    const PixelBounds bounds = pixels_of(tile);
    for (int y = bounds.y0; y < bounds.y1; ++y) {
        for (int x = bounds.x0; x < bounds.x1; ++x) {
            const double luminance = pair.around(x, y).y;
            if (!(luminance > 0.0)) continue;
            const auto [ex, ey, ez] = std::sqrt(static_cast<double>(samples_of_both)) / luminance * pair.error(x, y);
            const std::array<double, 6> products = {ex * ex, ex * ey, ex * ez, ey * ey, ey * ez, ez * ez};
            for (std::size_t k = 0; k < products.size(); ++k) noise.sum[k] += products[k];
            ++noise.pixels;
        }
    }
    noise_[tile] = noise;
}

StoppingRule::Noise StoppingRule::with_neighbours(std::size_t tile) const {
    const int columns = (first_.sample_bounds().width() + tile_px_ - 1) / tile_px_,
              rows = static_cast<int>(noise_.size()) / columns;
    const int column = static_cast<int>(tile) % columns, row = static_cast<int>(tile) / columns;
    Noise all;
    for (int v = std::max(0, row - 1); v <= std::min(row + 1, rows - 1); ++v) {
        for (int u = std::max(0, column - 1); u <= std::min(column + 1, columns - 1); ++u) {
            const Noise& one =
                noise_[static_cast<std::size_t>(v) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(u)];
            for (std::size_t k = 0; k < one.sum.size(); ++k) all.sum[k] += one.sum[k];
            all.pixels += one.pixels;
        }
    }
    return all;
}

void StoppingRule::look(std::uint64_t picture_samples, int threads) {
    const Pair pair = shown(threads);
    const ViewingConditions viewing = viewing_of(pair.around, observer(first_.options().sensor.observer));
    const std::vector<std::size_t> running = running_tiles();
    const auto for_each_running = [&](const auto& what) {
        parallel_for(0, static_cast<int>(running.size()), threads,
                     [&](int i) { what(running[static_cast<std::size_t>(i)]); });
    };
    for_each_running([&](std::size_t tile) { measure(tile, pair, 2 * pair_samples(picture_samples)); });
    for_each_running([&](std::size_t tile) {
        const PixelBounds bounds = pixels_of(tile);
        const Noise around = with_neighbours(tile);
        const auto root_mean_square = [&](const Noise& noise) {
            if (noise.pixels == 0) return 0.0;
            std::array<double, 6> covariance = noise.sum;
            for (double& value : covariance) value /= static_cast<double>(noise.pixels * picture_samples);
            const std::array<XYZd, 3> root = root_of(covariance);
            double sum = 0.0;
            for (int y = bounds.y0; y < bounds.y1; ++y) {
                for (int x = bounds.x0; x < bounds.x1; ++x) sum += squared_error(pair.around(x, y), root, viewing);
            }
            return std::sqrt(sum / (static_cast<double>(bounds.width()) * bounds.height()));
        };
        const bool known = around.pixels >= kFewestPixels || around.pixels == 0;
        if (known && root_mean_square(noise_[tile]) <= target_ && root_mean_square(around) <= target_)
            stopped_[tile] = 1;
    });
}

std::vector<std::size_t> StoppingRule::running_tiles() const {
    std::vector<std::size_t> running;
    for (std::size_t i = 0; i < stopped_.size(); ++i) {
        if (stopped_[i] == 0) running.push_back(i);
    }
    return running;
}

}  // namespace emulsion
