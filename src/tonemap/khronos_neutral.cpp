#include "tonemap/khronos_neutral.h"

namespace emulsion {

namespace {

/// Ld / L.
double curve_over_scaled(double scaled) noexcept {
    constexpr double kReflection = 0.04;  // of a dielectric at normal incidence, refractive index 1.5
    constexpr double kShoulder = 0.8 - kReflection, kRoom = 1.0 - kShoulder;
    if (scaled < 2.0 * kReflection) return scaled / (4.0 * kReflection);
    const double diffuse = scaled - kReflection;
    if (diffuse < kShoulder) return diffuse / scaled;
    return (1.0 - kRoom * kRoom / (diffuse + kRoom - kShoulder)) / scaled;
}

}  // namespace

Adaptation own_adaptation(const KhronosNeutral&) noexcept { return LogAverageAdaptation{}; }

ToneReproduction prepare(const KhronosNeutral& mapper, const SceneLuminance&, double) {
    return {.exposure = [key = double{mapper.key}](double adaptation) { return key / adaptation; },
            .compression = curve_over_scaled};
}

}  // namespace emulsion
