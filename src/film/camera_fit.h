#pragma once
// From what a camera responds to XYZ: one 3x3 matrix, found by least squares over surfaces of known reflectance.
//
// No camera is an exact linear transform of the eye, so that no matrix is right for every light. What is left of the
// differences over the training set is reported in CIEDE2000.

#include <optional>
#include <string>
#include <vector>

#include "core/matrix3.h"
#include "film/camera_response.h"
#include "spectrum/observer.h"
#include "spectrum/spectrum.h"

namespace emulsion {

/// How a camera is trained.
struct CameraTraining {
    Spectrum illuminant = DaylightSpectrum{};  ///< the camera looks at the surfaces under this; any scale; default D65
    /// The observer looks at them under this; unset: the same. Setting it trains the camera to bring one white to the
    /// other, as pbrt-v4 does with its whitebalance: to D65, from the daylight that the picture is balanced for.
    std::optional<Spectrum> target_illuminant = std::nullopt;
    bool operator==(const CameraTraining&) const = default;
};

/// The result, and how good it is.
struct CameraFit {
    Matrix3 xyz_from_camera;      ///< from the curves' integrals with L, in W m^-2 sr^-1, to the observer's with L
    double mean_ciede2000 = 0.0;  ///< over the training set, against the white of the target
    double max_ciede2000 = 0.0;
    std::string worst;  ///< the catalogue's name of the reflectance with the largest
    int reflectance_count = 0;
    bool operator==(const CameraFit&) const = default;
};

/// The catalogue's names of what a camera is trained with: the 24 patches of the ColorChecker, the 15 saturated Munsell
/// papers of the CQS, the 24 of AMPAS; 63 in all.
[[nodiscard]] const std::vector<std::string>& camera_training_names();

/// The matrix M that makes sum_i |M c_i - t_i|^2 smallest, over the training reflectances r_i under the illuminant E:
///     c_i = integral of r_i E (r, g, b)             / integral of E ybar      the camera
///     t_i = integral of r_i E' (xbar, ybar, zbar)   / integral of E' ybar     the target; E' = E unless set
/// A white surface in the light E then has its luminance, as nearly as the fit goes, and neither the scale of the
/// curves nor that of the illuminants matters. Differences in X, Y and Z count alike, dark surfaces less than light
/// ones; nothing holds the white fixed. Where the curves are an exact linear transform of the observer's functions and
/// E' = E, M is its inverse. Reflectances are 0 outside their tables (most: 380-780 nm), for camera and target alike.
/// Source: Pharr, Jakob & Humphreys, "Physically Based Rendering", 4th ed., section 5.4.2, `PixelSensor`. Departs from
/// it in the reflectances (there 24 of the ColorChecker or like it) and in E' = E by default.
/// \throws std::invalid_argument as validate(CameraResponse) and validate(Spectrum) do, for an illuminant without
/// luminance, and for curves that are linearly dependent over the training set.
[[nodiscard]] CameraFit fit_camera(const CameraResponse& response, const Observer& observer,
                                   const CameraTraining& training = {});

}  // namespace emulsion
