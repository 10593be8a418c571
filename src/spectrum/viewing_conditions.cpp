#include "spectrum/viewing_conditions.h"

#include <cmath>
#include <stdexcept>

#include <fmt/core.h>

#include "spectrum/chromaticity.h"
#include "spectrum/colorimetry.h"
#include "spectrum/named_spectra.h"
#include "spectrum/pq.h"
#include "spectrum/rgb_space.h"

namespace emulsion {

namespace {

/// NaN stays NaN.
double not_negative(double value) noexcept { return value < 0.0 ? 0.0 : value; }

}  // namespace

void validate(const ViewingConditions& viewing) {
    const auto [x, y, z] = viewing.white;
    constexpr double kTolerance = 1e-9;
    const bool is_white = std::isfinite(x) && std::isfinite(z) && x > 0.0 && z > 0.0 && std::abs(y - 1.0) <= kTolerance;
    if (!is_white) {
        throw std::invalid_argument(fmt::format("white ({}, {}, {}): expected finite X, Z > 0 and Y = 1", x, y, z));
    }
    const double luminance = viewing.white_luminance_cdm2;
    if (luminance >= 1e-30 && luminance <= 1e30) return;
    throw std::invalid_argument(fmt::format("white luminance {} cd/m^2: must be in [1e-30, 1e30]", luminance));
}

XYZd default_white(const Observer& observer) {
    if (observer.name == cie_1931_2deg().name) return xyz_of(rgb_space("Rec709").white);
    const XYZd light = xyz_of_radiance(named_spectrum("stdillum-D65").value(), observer);
    return (1.0 / light.y) * light;
}

XYZd shown_within(const XYZd& xyz, double most) noexcept {
    const XYZd light = {not_negative(xyz.x), not_negative(xyz.y), not_negative(xyz.z)};
    return light.y > most ? (most / light.y) * light : light;
}

Lab lab_as_viewed(const XYZd& xyz_cdm2, const ViewingConditions& viewing) noexcept {
    return lab_from_xyz(shown_within((1.0 / viewing.white_luminance_cdm2) * xyz_cdm2, 1.0), viewing.white);
}

ICtCp ictcp_as_viewed(const XYZd& xyz_cdm2, const ViewingConditions& viewing) {
    const double shown_per_cdm2 = kIctcpReferenceWhite_cdm2 / viewing.white_luminance_cdm2;
    return ictcp_from_xyz(shown_within(shown_per_cdm2 * xyz_cdm2, PqTransfer::kPeak_cdm2));
}

}  // namespace emulsion
