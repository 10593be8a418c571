#pragma once
// What a film's sensor is: how long it looks, how sensitive it is, with whose eyes or which camera's, and what it takes
// for white.
//
// A film holds XYZ of one observer, with Y = imaging ratio * luminance in cd/m^2. So a Y of 1 stands for a luminance of
// white_luminance_cdm2() = 1 / imaging ratio, which film files carry as whiteLuminance: what is read back from them is
// cd/m^2 again, whatever the exposure.

#include <optional>
#include <string>
#include <string_view>

#include "film/camera_fit.h"
#include "film/camera_response.h"
#include "film/sensor_white_balance.h"

namespace emulsion {

/// The imaging ratio, and its inverse, must fit into single precision with the values that they scale.
inline constexpr double kMinImagingRatio = 1e-30, kMaxImagingRatio = 1e30;

/// A measured camera, and how its matrix to XYZ is found.
struct CameraSensor {
    CameraResponse response;
    CameraTraining training = {};
    bool operator==(const CameraSensor&) const = default;
};

struct SensorOptions {
    double exposure_time_s = 1.0;                       ///< finite, > 0
    double iso = 100.0;                                 ///< finite, > 0
    std::string observer = "cie_1931_2deg";             ///< whose XYZ the film holds: any name that observer() takes
    std::optional<CameraSensor> camera = std::nullopt;  ///< unset: the sensor sees as the observer does
    std::optional<WhiteBalance> white_balance = std::nullopt;  ///< unset: none
    bool operator==(const SensorOptions&) const = default;
};

/// exposure_time_s * iso / 100, what XYZ are multiplied by; 1 by default. Source: Pharr, Jakob & Humphreys, "Physically
/// Based Rendering", 4th ed., section 5.4.2.
[[nodiscard]] double imaging_ratio(const SensorOptions& options) noexcept;

/// 1 / imaging_ratio: the luminance that a Y of 1 stands for.
[[nodiscard]] double white_luminance_cdm2(const SensorOptions& options) noexcept;

/// \throws std::invalid_argument naming the field, its value and its range; also for an imaging ratio outside
/// [kMinImagingRatio, kMaxImagingRatio], for an observer that doesn't exist, and for a camera that is balanced twice,
/// by white_balance and by a target_illuminant. What only the fit of a camera shows, Sensor's constructor finds.
void validate(const SensorOptions& options);

/// All options in a line, for people and for files: "exposure-time=1 iso=100 observer=cie-1931-2deg white-balance=none
/// camera=none". Sensors of the same text see the same: of a camera it has a hash of its curves and its training, and
/// the name (of a file, without its folders).
[[nodiscard]] std::string to_text(const SensorOptions& options);

/// What of such a text tells whether two sensors see the same: all but the name of the camera, which is for people. The
/// same curves in files of two names are the same camera.
[[nodiscard]] std::string_view without_camera_name(std::string_view sensor_text) noexcept;

}  // namespace emulsion
