#pragma once
// What a film and its tiles share, and never change.

#include <limits>
#include <memory>
#include <optional>

#include "film/film_channels.h"
#include "film/film_options.h"
#include "film/filter_footprint.h"
#include "film/sensor.h"

namespace emulsion {

struct FilmSetup {
    /// \throws std::invalid_argument as validate(FilmOptions), Sensor and FilterFootprint do, and for a LuminanceClamp
    /// whose product with the imaging ratio is outside [1e-30, 1e30].
    explicit FilmSetup(const FilmOptions& film_options);

    FilmOptions options;
    Sensor sensor;
    FilmChannels channels;
    std::optional<FilterFootprint> footprint;  ///< if samples or light are splatted
    PixelBounds bounds;                        ///< the film's pixels
    PixelBounds sample_bounds;                 ///< places that reach any of them, in whole pixels; may leave the frame
    /// Above it samples are scaled down: cd/m^2 times the imaging ratio.
    float max_luminance = std::numeric_limits<float>::max();
    int mean_groups = 0;  ///< of MedianOfMeans; 0 without
    /// Of the samples that a pixel has, by the filter alone; of a mean weight of 1. 1 without variances, and where
    /// pixels have sums of squared weights.
    double mean_square_weight = 1.0;
};

}  // namespace emulsion
