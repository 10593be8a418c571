#include "film/sensor_white_balance.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "core/parameters.h"
#include "core/visit.h"
#include "spectrum/integral.h"
#include "spectrum/spectrum.h"

namespace emulsion {

namespace {

constexpr ParameterRange kTemperatures_K = {1000.0, kMaxDaylight_K};

Spectrum light_of(const TemperatureWhite& white) {
    if (white.temperature_K < kMinDaylight_K) return BlackbodySpectrum{white.temperature_K};
    return DaylightSpectrum{white.temperature_K, DaylightWeights::exact};
}

void check(const TemperatureWhite& white) {
    check_range(white.temperature_K, kTemperatures_K, "white balance: temperature_K");
}
void check(const Chromaticity& white) {
    check_range(white.x, kFinite, "white balance: x of the white");
    check_range(white.y, kPositiveFinite, "white balance: y of the white");
}

/// With Y = 1.
XYZd white_of(const TemperatureWhite& white, const Observer& sensor) {
    const Spectrum light = light_of(white);
    const XYZd xyz = integral_with_observer({light}, sensor);
    if (xyz.y > 0.0) return (1.0 / xyz.y) * xyz;
    throw std::invalid_argument("white balance: the sensor sees a luminance of " + number_text(xyz.y) +
                                " in the light of " + number_text(white.temperature_K) + " K, expected one > 0");
}
XYZd white_of(const Chromaticity& white, const Observer& /*sensor*/) { return xyz_of(white); }

}  // namespace

void validate(const WhiteBalance& balance) {
    std::visit([](const auto& white) { check(white); }, balance.white);
    if (const auto* white = std::get_if<Chromaticity>(&balance.white)) {
        static_cast<void>(adaptation_matrix(balance.method, xyz_of(*white), xyz_of(kWorkingWhite)));
    }
}

Matrix3 white_balance_matrix(const WhiteBalance& balance, const Observer& sensor) {
    validate(balance);
    const XYZd from = std::visit([&](const auto& white) { return white_of(white, sensor); }, balance.white);
    return adaptation_matrix(balance.method, from, xyz_of(kWorkingWhite));
}

}  // namespace emulsion
