#include "film/sensor.h"

#include <array>
#include <cassert>
#include <cstddef>

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
    const auto numbers = [](const Response& value) {
        return std::array<double, 4>{value.xyz.x, value.xyz.y, value.xyz.z, value.luminance};
    };
    for (int nm = kMinWavelength_nm; nm < kMaxWavelength_nm; ++nm) {
        const auto response_at = [&](int end) {
            return Response{scale * value_on(functions, nm, end), scale * value_on(observer, nm, end).y};
        };
        const Response start = response_at(0), end = response_at(1);
        responses_.set(cells_.size(), numbers(start), numbers(end));
        cells_.push_back({start, end});
    }
}

SensorSample Sensor::sense(std::span<const float> lambda_nm, std::span<const float> radiance,
                           std::span<const float> pdf) const noexcept {
    const std::size_t count = lambda_nm.size();
    assert(count >= 1 && radiance.size() == count && pdf.size() == count);
    const float scale = 4.0f / static_cast<float>(count);
    const auto load = [&](std::size_t first, std::size_t of) {
        return FourWavelengths::load(lambda_nm.data() + first, pdf.data() + first, radiance.data() + first, of);
    };
    // Four are copied in registers, as the compiler knows their number; fewer are not.
    const auto four_from = [&](std::size_t first) { return responses_.sum(load(first, 4), scale); };
    const auto rest_from = [&](std::size_t first) { return responses_.sum(load(first, count - first), scale); };

    Float4 sum = count < 4 ? rest_from(0) : four_from(0);
    std::size_t first = 4;
    for (; first + 4 <= count; first += 4) sum += four_from(first);
    if (first < count) sum += rest_from(first);
    return {{sum[0], sum[1], sum[2]}, sum[3]};
}

Sensor::Response Sensor::at(double lambda_nm) const noexcept {
    const double above = lambda_nm - kMinWavelength_nm;
    if (!(above >= 0.0 && lambda_nm < kMaxWavelength_nm)) {
        const double none = above - above;  // 0, or NaN
        return {{none, none, none}, none};
    }
    const auto i = static_cast<std::size_t>(above);
    const double fraction = above - static_cast<double>(i);
    const auto& [start, end] = cells_[i];
    return {(1.0 - fraction) * start.xyz + fraction * end.xyz,
            (1.0 - fraction) * start.luminance + fraction * end.luminance};
}

XYZd Sensor::response(double lambda_nm) const noexcept { return at(lambda_nm).xyz; }

double Sensor::luminance_response(double lambda_nm) const noexcept { return at(lambda_nm).luminance; }

}  // namespace emulsion
