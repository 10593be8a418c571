#include "spectrum/color_rendering.h"

#include <cmath>
#include <stdexcept>

#include <fmt/core.h>

#include "spectrum/chromaticity.h"
#include "spectrum/cie_1964_uvw.h"
#include "spectrum/color_temperature.h"
#include "spectrum/colorimetry.h"
#include "spectrum/data_table.h"
#include "spectrum/observer.h"
#include "spectrum/spectrum_daylight.h"

namespace emulsion {

namespace {

using Integration = ColorRenderingMethod::Integration;

Spectrum reference_of(double temperature_K, const ColorRenderingMethod& method) {
    if (temperature_K < method.daylight_from_K) return BlackbodySpectrum{temperature_K};
    if (temperature_K <= kMaxDaylight_K) return DaylightSpectrum{temperature_K, DaylightWeights::exact};
    throw std::invalid_argument(
        fmt::format("colour rendering: colour temperature {} K: expected at most {} K", temperature_K, kMaxDaylight_K));
}

// XYZ of a reflectance, with Y = 1 for the perfect reflector.
XYZd seen(const Spectrum& reflectance, const Spectrum& light, Integration integration) {
    if (integration == Integration::exact) return xyz_of_reflectance(reflectance, light);
    return xyz_by_summation(reflectance, light, cie_1931_2deg(), 380.0, 780.0, 5.0);
}

// The quantities in which the standard scales chromaticities, as von Kries scales the responses of the cones.
struct Adaptation {
    double c, d;
};

Adaptation adaptation_of(const Uv1960& uv) noexcept {
    return {(4.0 - uv.u - 10.0 * uv.v) / uv.v, (1.708 * uv.v + 0.404 - 1.481 * uv.u) / uv.v};
}

// What `uv`, seen by an eye adapted to the light, looks like to one adapted to the reference. The rounded coefficients
// make an exact inverse all the same: the light becomes the reference, and where the two are equal nothing changes.
Uv1960 adapted(const Uv1960& uv, const Uv1960& light, const Uv1960& reference) noexcept {
    const Adaptation color = adaptation_of(uv), from = adaptation_of(light), to = adaptation_of(reference);
    const double c = to.c / from.c * color.c, d = to.d / from.d * color.d;
    const double denominator = 16.518 + 1.481 * c - d;
    return {(10.872 + 0.404 * c - 4.0 * d) / denominator, 5.520 / denominator};
}

void validate(const ColorRenderingMethod& method) {
    if (method.daylight_from_K >= kMinDaylight_K && method.daylight_from_K <= kMaxDaylight_K) return;
    throw std::invalid_argument(fmt::format("colour rendering: daylight_from_K = {}: expected a number in [{}, {}]",
                                            method.daylight_from_K, kMinDaylight_K, kMaxDaylight_K));
}

}  // namespace

ColorRendering color_rendering(const Spectrum& light, const ColorRenderingMethod& method) {
    validate(method);
    validate(light);

    // The reference: a blackbody or daylight of the light's colour temperature.
    const Uv1960 light_uv = uv_1960_of(seen(ConstantSpectrum{1.0}, light, method.integration));
    const auto temperature = cie_1931_planckian_locus().nearest(light_uv);
    if (!temperature) {
        throw std::invalid_argument(
            "colour rendering: the light has no correlated colour temperature: expected a nearly white light");
    }
    const Spectrum reference = reference_of(temperature->temperature_K, method);
    const Uv1960 reference_uv = uv_1960_of(seen(ConstantSpectrum{1.0}, reference, method.integration));

    ColorRendering result;
    result.reference_K = temperature->temperature_K;
    result.reference_distance = std::hypot(light_uv.u - reference_uv.u, light_uv.v - reference_uv.v);
    for (std::size_t i = 0; i < kTestColorCount; ++i) {
        const Spectrum test_color = tabulated_spectrum("munsell_cri_tcs_5nm", fmt::format("TCS{:02}", i + 1));
        const XYZd under_light = seen(test_color, light, method.integration),
                   under_reference = seen(test_color, reference, method.integration);
        const Cie1964Uvw a =
            uvw_of(adapted(uv_1960_of(under_light), light_uv, reference_uv), under_light.y, reference_uv);
        const Cie1964Uvw b = uvw_of(uv_1960_of(under_reference), under_reference.y, reference_uv);
        result.special_index[i] =
            100.0 - 4.6 * std::sqrt((a.u - b.u) * (a.u - b.u) + (a.v - b.v) * (a.v - b.v) + (a.w - b.w) * (a.w - b.w));
        if (i < 8) result.general_index += result.special_index[i] / 8.0;
    }
    return result;
}

}  // namespace emulsion
