#include "pathtracer/stopping_rule.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <variant>

#include "core/parallel.h"
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

/// Of the mean of the two.
ViewingConditions viewing_of(const Image<XYZ>& first, const Image<XYZ>& second, const Observer& observer) {
    double sum = 0.0;
    std::int64_t positive = 0;
    for (std::size_t i = 0; i < first.pixels().size(); ++i) {
        const double luminance = 0.5 * (static_cast<double>(first.pixels()[i].y) + second.pixels()[i].y);
        if (!(luminance > 0.0)) continue;
        sum += std::log(luminance);
        ++positive;
    }
    ViewingConditions viewing{.white = default_white(observer)};
    if (positive == 0) return viewing;
    const double white = white_luminance_of_log_average(std::exp(sum / static_cast<double>(positive)));
    viewing.white_luminance_cdm2 = std::clamp(white, 1e-30, 1e30);
    return viewing;
}

/// Square of the CIEDE2000 of a pixel's error `scale` times half the difference of the two. Half that between the error
/// and its opposite is what the error is where the scale is even, and stays defined where it is not.
double squared_error(const XYZd& first, const XYZd& second, double scale, const ViewingConditions& viewing) noexcept {
    const XYZd mean = 0.5 * (first + second), error = 0.5 * scale * (first + -1.0 * second);
    const double across = difference(Ciede2000Difference{}, lab_as_viewed(mean + error, viewing),
                                     lab_as_viewed(mean + -1.0 * error, viewing));
    return 0.25 * across * across;
}

XYZd in_double(const XYZ& xyz) noexcept { return {xyz.x, xyz.y, xyz.z}; }

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
      stopped_(tile_count(first_.sample_bounds(), tile_px)) {}

std::uint64_t StoppingRule::pair_samples(std::uint64_t picture_samples) noexcept {
    return std::max(kFewestPairSamples, picture_samples / kSamplesPerPairSample);
}

void StoppingRule::look(std::uint64_t picture_samples, int threads) {
    const Image<XYZ> first = first_.xyz_image(), second = second_.xyz_image();
    const ViewingConditions viewing = viewing_of(first, second, observer(first_.options().sensor.observer));
    const double scale =
        std::sqrt(2.0 * static_cast<double>(pair_samples(picture_samples)) / static_cast<double>(picture_samples));
    const PixelBounds& places = first_.sample_bounds();  // of importance sampled filters, the film's pixels
    const std::vector<std::size_t> running = running_tiles();
    parallel_for(0, static_cast<int>(running.size()), threads, [&](int i) {
        const std::size_t tile = running[static_cast<std::size_t>(i)];
        const PixelBounds bounds = tile_bounds(places, tile_px_, tile);
        double sum = 0.0;
        for (int y = bounds.y0 - places.y0; y < bounds.y1 - places.y0; ++y) {
            for (int x = bounds.x0 - places.x0; x < bounds.x1 - places.x0; ++x) {
                sum += squared_error(in_double(first(x, y)), in_double(second(x, y)), scale, viewing);
            }
        }
        const double mean_square = sum / (static_cast<double>(bounds.width()) * bounds.height());
        if (std::sqrt(mean_square) <= target_) stopped_[tile] = 1;
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
