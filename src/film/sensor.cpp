#include "film/sensor.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "spectrum/observer.h"

namespace emulsion {

Sensor::Sensor(double imaging_ratio) : imaging_ratio_(imaging_ratio) {
    if (!std::isfinite(imaging_ratio) || imaging_ratio <= 0.0) {
        throw std::invalid_argument("sensor: imaging_ratio is " + std::to_string(imaging_ratio) +
                                    ", expected a finite number > 0");
    }

    const Observer& observer = cie_1931_2deg();
    for (int lambda_nm = kMinWavelength_nm; lambda_nm <= kMaxWavelength_nm; ++lambda_nm) {
        response_.push_back(kLuminousEfficacy * imaging_ratio * eval(observer, lambda_nm));
    }
    for (std::size_t i = 0; i + 1 < response_.size(); ++i) {
        const XYZd start = response_[i], end = response_[i + 1];
        const auto four = [](const XYZd& value) {
            return Float4{static_cast<float>(value.x), static_cast<float>(value.y), static_cast<float>(value.z), 0.0f};
        };
        lines_.push_back({four(start), four(end + -1.0 * start)});
    }
}

XYZd Sensor::response(double lambda_nm) const noexcept {
    const double above = lambda_nm - kMinWavelength_nm;
    if (!(above >= 0.0 && lambda_nm <= kMaxWavelength_nm)) return {};
    const auto cell = static_cast<std::size_t>(above);
    if (cell + 1 == response_.size()) return response_.back();
    const double fraction = above - static_cast<double>(cell);
    return (1.0 - fraction) * response_[cell] + fraction * response_[cell + 1];
}

}  // namespace emulsion
