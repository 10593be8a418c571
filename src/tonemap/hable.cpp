#include "tonemap/hable.h"

namespace emulsion {

namespace {

/// h(x) / x, the terms of h brought over one denominator, in which D E cancels.
double filmic_over_x(double x) noexcept {
    constexpr double kA = 0.15, kB = 0.50, kC = 0.10, kD = 0.20, kE = 0.02, kF = 0.30;
    constexpr double kToe = kE / kF;
    // Above 1, numerator and denominator are divided by x^2, which may be too large.
    if (x > 1.0) return (kA * (1.0 - kToe) + kB * (kC - kToe) / x) / (kA * x + kB + kD * kF / x);
    return (kA * (1.0 - kToe) * x + kB * (kC - kToe)) / ((kA * x + kB) * x + kD * kF);
}

}  // namespace

Adaptation own_adaptation(const HableFilmic&) noexcept { return LogAverageAdaptation{}; }

ToneReproduction prepare(const HableFilmic& mapper, const SceneLuminance&, double) {
    constexpr double kExposureBias = 2.0;
    const double key = mapper.key, white = kExposureBias * mapper.white;
    const double shown_white = white * filmic_over_x(white);
    return {.exposure = [=](double adaptation) { return key / adaptation; },
            .compression =
                [=](double scaled) { return kExposureBias * filmic_over_x(kExposureBias * scaled) / shown_white; }};
}

}  // namespace emulsion
