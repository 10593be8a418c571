#pragma once

namespace emulsion {

/// Middle grey relative to white: a grey card, and zone V.
inline constexpr double kMiddleGrey = 0.18;

}  // namespace emulsion
