#include "film/sensor_options.h"

#include <stdexcept>

#include "core/parameters.h"

namespace emulsion {

double imaging_ratio(const SensorOptions& options) noexcept { return options.exposure_time_s * options.iso / 100.0; }

double white_luminance_cdm2(const SensorOptions& options) noexcept { return 1.0 / imaging_ratio(options); }

void validate(const SensorOptions& options) {
    check_range(options.exposure_time_s, kPositiveFinite, "sensor: exposure_time_s");
    check_range(options.iso, kPositiveFinite, "sensor: iso");
    check_range(imaging_ratio(options), {kMinImagingRatio, kMaxImagingRatio},
                "sensor: imaging ratio (exposure_time_s * iso / 100)");
    static_cast<void>(observer(options.observer));
    if (options.white_balance) validate(*options.white_balance);
    if (!options.camera) return;
    validate(options.camera->response);
    validate(options.camera->training.illuminant);
    if (!options.camera->training.target_illuminant) return;
    validate(*options.camera->training.target_illuminant);
    if (options.white_balance) {
        throw std::invalid_argument("sensor: camera " + options.camera->response.name +
                                    " has a target_illuminant as well as a white_balance, expected one of them");
    }
}

}  // namespace emulsion
