#include "spectrum/cie_rgb_observer.h"

#include <cmath>
#include <cstddef>
#include <stdexcept>

#include <fmt/core.h>

#include "spectrum/one_nm_table.h"

namespace emulsion {

namespace {

/// The XYZ of one unit of power at each primary's wavelength, as columns.
Matrix3 xyz_of_primaries(const Observer& observer, const std::array<double, 3>& primaries_nm) {
    Matrix3 columns;
    for (std::size_t j = 0; j < 3; ++j) {
        const double lambda_nm = primaries_nm[j];
        if (!(lambda_nm >= observer.first_nm && lambda_nm <= observer.last_nm())) {
            throw std::invalid_argument(fmt::format("primaries_nm[{}] = {}: expected a wavelength from {} to {} nm", j,
                                                    lambda_nm, observer.first_nm, observer.last_nm()));
        }
        const XYZd xyz = eval(observer, lambda_nm);
        columns.m[0][j] = xyz.x;
        columns.m[1][j] = xyz.y;
        columns.m[2][j] = xyz.z;
    }
    return columns;
}

}  // namespace

RgbObserver rgb_observer(const Observer& observer, const std::array<double, 3>& primaries_nm) {
    const Matrix3 primaries = xyz_of_primaries(observer, primaries_nm);
    XYZd white;
    for (const XYZd& value : observer.value) white = white + value;

    // Powers of the primaries that match the equal-energy spectrum, in units of that of red's luminance.
    const std::array<double, 3> power = inverse(primaries) * std::array<double, 3>{white.x, white.y, white.z};
    const double red_luminance = primaries.m[1][0] * power[0];
    if (!(std::abs(red_luminance) > 0.0)) {
        throw std::invalid_argument(
            fmt::format("primaries_nm[0] = {}: expected a wavelength that has a luminance", primaries_nm[0]));
    }
    RgbObserver rgb{observer.name + " RGB", observer.first_nm, {}, primaries};
    for (auto& row : rgb.xyz_from_rgb.m) {
        for (std::size_t j = 0; j < 3; ++j) row[j] *= power[j] / red_luminance;
    }

    const Matrix3 rgb_from_xyz = inverse(rgb.xyz_from_rgb);
    for (const XYZd& value : observer.value) {
        const auto [r, g, b] = rgb_from_xyz * std::array<double, 3>{value.x, value.y, value.z};
        rgb.value.push_back({r, g, b});
    }
    return rgb;
}

const RgbObserver& cie_rgb_1931() {
    static const RgbObserver observer = rgb_observer(cie_1931_2deg(), kCieRgbPrimaries_nm);
    return observer;
}

RGBd eval(const RgbObserver& observer, double lambda_nm) noexcept {
    return value_at(observer.first_nm, observer.value, lambda_nm);
}

}  // namespace emulsion
