#include "spectrum/daylight.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string_view>

#include <fmt/core.h>

#include "core/units.h"
#include "spectrum/colorimetry.h"
#include "spectrum/data_table.h"

namespace emulsion {

PiecewiseLinearSpectrum daylight(const Chromaticity& chromaticity) {
    constexpr std::string_view kTable = "cie_daylight_basis_5nm";
    const std::array<PiecewiseLinearSpectrum, 3> component = {
        tabulated_spectrum(kTable, "S0"), tabulated_spectrum(kTable, "S1"), tabulated_spectrum(kTable, "S2")};

    // X - x (X + Y + Z) and Y - y (X + Y + Z) must vanish for the mixture: two equations for M1 and M2.
    std::array<std::array<double, 3>, 2> equation{};
    for (std::size_t j = 0; j < 3; ++j) {
        const XYZd xyz = xyz_of_radiance(component[j]);
        const double sum = xyz.x + xyz.y + xyz.z;
        equation[0][j] = xyz.x - chromaticity.x * sum;
        equation[1][j] = xyz.y - chromaticity.y * sum;
    }
    const auto minor = [&](std::size_t i, std::size_t j) {
        return equation[0][i] * equation[1][j] - equation[0][j] * equation[1][i];
    };
    const double m1 = minor(2, 0) / minor(1, 2), m2 = minor(0, 1) / minor(1, 2);

    PiecewiseLinearSpectrum mixture;
    for (std::size_t i = 0; i < component[0].lambda_nm.size(); ++i) {
        const double lambda_nm = component[0].lambda_nm[i];
        if (lambda_nm < kMinWavelength_nm || lambda_nm > kMaxWavelength_nm) continue;
        const double value = component[0].value[i] + m1 * component[1].value[i] + m2 * component[2].value[i];
        if (!(std::isfinite(value) && value >= 0.0)) {
            throw std::invalid_argument(
                fmt::format("daylight of chromaticity ({}, {}) would be {} at {} nm: expected one nearer to daylight",
                            chromaticity.x, chromaticity.y, value, lambda_nm));
        }
        mixture.lambda_nm.push_back(lambda_nm);
        mixture.value.push_back(value);
    }
    return mixture;
}

}  // namespace emulsion
