#pragma once
// Sensors of every kind, and integrals with what they respond.

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/units.h"
#include "film/sensor.h"
#include "spectrum/catalogue.h"
#include "spectrum/colorimetry.h"
#include "spectrum/integral.h"

namespace emulsion::testing {

/// Three overlapping humps: like a camera, and no linear transform of the eye.
inline CameraResponse humps_camera() {
    CameraResponse camera{"humps", {}, {}};
    const auto hump = [](double lambda_nm, double centre_nm, double width_nm) {
        return std::exp(-0.5 * std::pow((lambda_nm - centre_nm) / width_nm, 2.0));
    };
    for (int nm = 380; nm <= 780; nm += 5) {
        camera.lambda_nm.push_back(nm);
        camera.value.push_back({hump(nm, 600.0, 35.0), 0.9 * hump(nm, 540.0, 38.0), 0.7 * hump(nm, 455.0, 28.0)});
    }
    return camera;
}

inline XYZd product(const Matrix3& matrix, const XYZd& v) {
    const std::array<double, 3> result = matrix * std::array<double, 3>{v.x, v.y, v.z};
    return {result[0], result[1], result[2]};
}

/// A camera that responds (r, g, b) = camera_from_xyz * (xbar, ybar, zbar).
inline CameraResponse linear_camera(const Observer& observer, const Matrix3& camera_from_xyz) {
    CameraResponse camera{"linear", {}, {}};
    for (int nm = observer.first_nm; nm <= observer.last_nm(); ++nm) {
        const XYZd rgb = product(camera_from_xyz, eval(observer, nm));
        camera.lambda_nm.push_back(nm);
        camera.value.push_back({rgb.x, rgb.y, rgb.z});
    }
    return camera;
}

struct NamedSensor {
    std::string name;
    SensorOptions options;
};

/// Each observer, a camera, balances from both sides of D65 and by both descriptions of a white, and combinations.
inline std::vector<NamedSensor> every_sensor() {
    std::vector<NamedSensor> all;
    for (const std::string_view name : observer_names()) {
        SensorOptions options{.observer = std::string(name)};
        all.push_back({options.observer, options});
        options.white_balance = WhiteBalance{TemperatureWhite{3200.0}};
        all.push_back({options.observer + ", 3200 K", options});
    }
    const CameraSensor camera{humps_camera(), {}};
    all.push_back({"1931, blue sky", {.white_balance = WhiteBalance{TemperatureWhite{20000.0}}}});
    all.push_back({"1931, A by x and y", {.iso = 250.0, .white_balance = WhiteBalance{Chromaticity{0.4476, 0.4074}}}});
    all.push_back({"camera", {.exposure_time_s = 0.04, .iso = 800.0, .camera = camera}});
    all.push_back({"camera, 3200 K", {.camera = camera, .white_balance = WhiteBalance{TemperatureWhite{3200.0}}}});
    return all;
}

/// 683 * imaging ratio * balance * matrix * integrals, each from its own source and none from Sensor.
inline XYZd expected_xyz(const SensorOptions& options, const Spectrum& radiance) {
    const Observer& eye = observer(options.observer);
    Observer functions = eye;
    if (options.camera) {
        functions = at_whole_nm(options.camera->response);
        const CameraFit fit = fit_camera(options.camera->response, eye, options.camera->training);
        for (XYZd& value : functions.value) value = product(fit.xyz_from_camera, value);
    }
    XYZd xyz = integral_with_observer({radiance}, functions);
    if (options.white_balance) xyz = product(white_balance_matrix(*options.white_balance, functions), xyz);
    return (kLuminousEfficacy * options.exposure_time_s * options.iso / 100.0) * xyz;
}

/// The integral of L * response over the sensor's own table, by Gauss's rule of three abscissae a nanometre: exact for
/// products of straight lines that meet at whole nanometres.
inline XYZd seen_by(const Sensor& sensor, const Spectrum& radiance) {
    const std::array<std::pair<double, double>, 3> rule = {
        {{0.5 - std::sqrt(0.15), 5.0 / 18.0}, {0.5, 8.0 / 18.0}, {0.5 + std::sqrt(0.15), 5.0 / 18.0}}};
    XYZd sum;
    for (int nm = kMinWavelength_nm; nm < kMaxWavelength_nm; ++nm) {
        for (const auto& [offset, weight] : rule) {
            sum = sum + weight * eval(radiance, nm + offset) * sensor.response(nm + offset);
        }
    }
    return sum;
}

inline std::array<double, 3> components(const XYZd& xyz) { return {xyz.x, xyz.y, xyz.z}; }

}  // namespace emulsion::testing
