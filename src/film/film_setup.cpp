#include "film/film_setup.h"

#include "film/filter_sampler.h"

namespace emulsion {

namespace {

const FilmOptions& validated(const FilmOptions& options) {
    validate(options);
    validate_clamp(options);
    return options;
}

/// What samples are compared with, in single precision: with the imaging ratio.
float max_luminance_of(const LuminanceClamp& clamp, const SensorOptions& sensor) {
    return static_cast<float>(static_cast<double>(clamp.max_luminance_cdm2) * imaging_ratio(sensor));
}

}  // namespace

FilmSetup::FilmSetup(const FilmOptions& film_options)
    : options(validated(film_options)),
      sensor(options.sensor),
      channels(options),
      bounds(bounds_of(options)),
      sample_bounds(bounds) {
    if (options.filter_use == FilterUse::splatted || options.light_splats) {
        footprint.emplace(options.filter);
        sample_bounds = footprint->places_that_reach(bounds);
    }
    if (const auto* const clamp = std::get_if<LuminanceClamp>(&options.firefly_control)) {
        max_luminance = max_luminance_of(*clamp, options.sensor);
    }
    if (const auto* const median = std::get_if<MedianOfMeans>(&options.firefly_control)) mean_groups = median->groups;
    if (options.variance != FilmVariance::none && channels.squared_weights.size == 0) {
        mean_square_weight = options.filter_use == FilterUse::splatted
                                 ? footprint->mean_square_weight()
                                 : FilterSampler(options.filter).mean_square_weight();
    }
}

}  // namespace emulsion
