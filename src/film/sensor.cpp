#include "film/sensor.h"

#include <array>

#include "spectrum/observer.h"

namespace emulsion {

namespace {

XYZd product(const Matrix3& matrix, const XYZd& xyz) {
    const std::array<double, 3> result = matrix * std::array<double, 3>{xyz.x, xyz.y, xyz.z};
    return {result[0], result[1], result[2]};
}

void transform(const Matrix3& matrix, Observer& functions) {
    for (XYZd& value : functions.value) value = product(matrix, value);
}

/// The value at one end of the nanometre that starts at cell_nm; 0 where the table hasn't the whole of it.
XYZd value_on(const Observer& functions, int cell_nm, int end) {
    if (cell_nm < functions.first_nm || cell_nm + 1 > functions.last_nm()) return {};
    return functions.value[static_cast<std::size_t>(cell_nm + end - functions.first_nm)];
}

}  // namespace

Sensor::Sensor(const SensorOptions& options) : options_(options) {
    validate(options);
    const Observer& observer = emulsion::observer(options.observer);

    // The functions by which the sensor sees.
    Observer functions = observer;
    if (options.camera) {
        camera_fit_ = fit_camera(options.camera->response, observer, options.camera->training);
        functions = at_whole_nm(options.camera->response);
        transform(camera_fit_->xyz_from_camera, functions);
    }
    if (options.white_balance) transform(white_balance_matrix(*options.white_balance, functions), functions);

    // Their values in lm/W, by nanometre.
    const double scale = kLuminousEfficacy * imaging_ratio();
    const auto four = [](const Response& value) {
        return Float4{static_cast<float>(value.xyz.x), static_cast<float>(value.xyz.y), static_cast<float>(value.xyz.z),
                      static_cast<float>(value.luminance)};
    };
    for (int nm = kMinWavelength_nm; nm < kMaxWavelength_nm; ++nm) {
        const auto response_at = [&](int end) {
            return Response{scale * value_on(functions, nm, end), scale * value_on(observer, nm, end).y};
        };
        const Response start = response_at(0), end = response_at(1);
        cells_.push_back({start, end});
        lines_.push_back({four(start), four({end.xyz + -1.0 * start.xyz, end.luminance - start.luminance})});
    }
}

Sensor::Response Sensor::at(double lambda_nm) const noexcept {
    const double above = lambda_nm - kMinWavelength_nm;
    if (!(above >= 0.0 && lambda_nm <= kMaxWavelength_nm)) return {};
    const auto i = static_cast<std::size_t>(above);
    if (i == cells_.size()) return cells_.back().end;
    const double fraction = above - static_cast<double>(i);
    const auto& [start, end] = cells_[i];
    return {(1.0 - fraction) * start.xyz + fraction * end.xyz,
            (1.0 - fraction) * start.luminance + fraction * end.luminance};
}

XYZd Sensor::response(double lambda_nm) const noexcept { return at(lambda_nm).xyz; }

double Sensor::luminance_response(double lambda_nm) const noexcept { return at(lambda_nm).luminance; }

}  // namespace emulsion
