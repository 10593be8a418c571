#pragma once
// How bright a display is. What light it can't help to show is on top of every colour: its own at signal 0 (black), and
// what the room's light makes of its surface (flare), both taken to be of the colour of its white. The signal is chosen
// so that signal (peak - black) + black + flare is proportional to the wanted luminance, and 1 for white; what is
// darker than black and flare can't be shown. With both at 0, as by default, signal and wanted luminance are the same,
// and the peak matters only to codes that stand for luminances (PQ) or depend on the peak (HLG).

#include "core/parameters.h"

namespace emulsion {

struct DisplayLight {
    double peak_cdm2 = 80.0;  ///< luminance of white, without flare
    double black_cdm2 = 0.0;  ///< luminance of signal 0, without flare; below the peak
    double flare_cdm2 = 0.0;  ///< the room's light, on white and black alike
    bool operator==(const DisplayLight&) const = default;
};

inline constexpr ParameterRange kPeak_cdm2 = {10.0, 10000.0};
inline constexpr ParameterRange kBlack_cdm2 = {0.0, 5.0};
inline constexpr ParameterRange kFlare_cdm2 = {0.0, 1000.0};

/// The parameters of all displays.
template <class T>
[[nodiscard]] constexpr Parameter<T> peak_parameter(const ParameterRange& range = kPeak_cdm2) noexcept {
    return {"peak", &T::peak_cdm2, range, "cd/m^2", "luminance of white"};
}
template <class T>
[[nodiscard]] constexpr Parameter<T> black_parameter() noexcept {
    return {"black", &T::black_cdm2, kBlack_cdm2, "cd/m^2", "luminance of black in a dark room"};
}
template <class T>
[[nodiscard]] constexpr Parameter<T> flare_parameter() noexcept {
    return {"flare", &T::flare_cdm2, kFlare_cdm2, "cd/m^2", "luminance of the room's light on the screen"};
}

/// signal = gain wanted - pedestal, both relative, 1 for white.
struct SignalScale {
    double gain = 1.0, pedestal = 0.0;
    bool operator==(const SignalScale&) const = default;
};

/// gain = (peak + flare) / (peak - black), pedestal = (black + flare) / (peak - black); exactly 1 and 0 without either.
[[nodiscard]] constexpr SignalScale signal_scale(const DisplayLight& light) noexcept {
    const double span = light.peak_cdm2 - light.black_cdm2;
    return {(light.peak_cdm2 + light.flare_cdm2) / span, (light.black_cdm2 + light.flare_cdm2) / span};
}

/// Luminance that is shown for a signal, without flare, relative to white's: black / peak + signal (1 - black / peak).
/// Exactly the signal without a black.
[[nodiscard]] constexpr double shown_share(const DisplayLight& light, double signal) noexcept {
    const double black = light.black_cdm2 / light.peak_cdm2;
    return black * (1.0 - signal) + signal;
}

}  // namespace emulsion
