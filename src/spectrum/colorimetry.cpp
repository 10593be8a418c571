#include "spectrum/colorimetry.h"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include "core/units.h"
#include "spectrum/integral.h"

namespace emulsion {

namespace {

/// Subnormal numbers are refused, too: their reciprocals are infinite.
void require_light(double luminance) {
    if (std::isnormal(luminance)) return;
    throw std::invalid_argument(
        fmt::format("illuminant: its luminance is {}, expected a finite number other than 0", luminance));
}

/// first_nm, first_nm + step_nm, ... up to last_nm.
std::vector<double> grid_nm(double first_nm, double last_nm, double step_nm) {
    constexpr double kMostSteps = 1e6;
    // 780 may be reached a rounding error too late.
    const double steps = std::floor((last_nm - first_nm) / step_nm * (1.0 + 1e-12));
    if (!std::isfinite(first_nm) || !(step_nm > 0.0) || !(steps >= 0.0 && steps <= kMostSteps)) {
        throw std::invalid_argument(
            fmt::format("summation: {} nm to {} nm by {} nm: expected finite numbers in order, a step > 0, and at most "
                        "a million steps",
                        first_nm, last_nm, step_nm));
    }
    std::vector<double> grid(static_cast<std::size_t>(steps) + 1);
    for (std::size_t i = 0; i < grid.size(); ++i) grid[i] = first_nm + static_cast<double>(i) * step_nm;
    return grid;
}

std::vector<double> values_on(const std::vector<double>& grid_nm, const Spectrum& spectrum) {
    validate(spectrum);
    if (!delta_lines(spectrum).empty()) {
        throw std::invalid_argument(
            "summation: the spectrum has lines without width: expected a continuum only, or an integral in place of "
            "the sum");
    }
    std::vector<double> values(grid_nm.size());
    eval(spectrum, grid_nm, values);
    return values;
}

}  // namespace

double photometric_integral(const Spectrum& spectrum) { return integral_with_observer({spectrum}, cie_1931_2deg()).y; }

double light_normalisation(const Spectrum& spectrum) {
    if (const auto* light = std::get_if<RgbIlluminantSpectrum>(&spectrum)) {
        validate(spectrum);
        return photometric_integral(light->illuminant);
    }
    return photometric_integral(spectrum);
}

XYZd xyz_of_radiance(const Spectrum& radiance, const Observer& observer) {
    return kLuminousEfficacy * integral_with_observer({radiance}, observer);
}

XYZd xyz_of_reflectance(const Spectrum& reflectance, const Spectrum& illuminant, const Observer& observer) {
    const double white = integral_with_observer({illuminant}, observer).y;
    require_light(white);
    return (1.0 / white) * integral_with_observer({reflectance, illuminant}, observer);
}

XYZd xyz_by_summation(const Spectrum& reflectance, const Spectrum& illuminant, const Observer& observer,
                      double first_nm, double last_nm, double step_nm) {
    const std::vector<double> lambda_nm = grid_nm(first_nm, last_nm, step_nm);
    const std::vector<double> light = values_on(lambda_nm, illuminant), share = values_on(lambda_nm, reflectance);
    XYZd sum;
    double white = 0.0;
    for (std::size_t i = 0; i < lambda_nm.size(); ++i) {
        const XYZd weighted = light[i] * eval(observer, lambda_nm[i]);
        sum = sum + share[i] * weighted;
        white += weighted.y;
    }
    require_light(white);
    return (1.0 / white) * sum;
}

XYZd xyz_of_radiance_by_summation(const Spectrum& radiance, const Observer& observer, double first_nm, double last_nm,
                                  double step_nm) {
    const std::vector<double> lambda_nm = grid_nm(first_nm, last_nm, step_nm);
    const std::vector<double> values = values_on(lambda_nm, radiance);
    XYZd sum;
    for (std::size_t i = 0; i < lambda_nm.size(); ++i) sum = sum + values[i] * eval(observer, lambda_nm[i]);
    return (kLuminousEfficacy * step_nm) * sum;
}

}  // namespace emulsion
