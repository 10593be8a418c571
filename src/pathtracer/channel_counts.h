#pragma once
// For explicit instantiations.

/// Expands macro(N) for each of kWavelengthCounts.
#define EMULSION_FOR_EACH_WAVELENGTH_COUNT(macro) macro(1) macro(2) macro(4) macro(8) macro(16) macro(32)

/// Expands macro(K) for each of kFixedChannelCounts.
#define EMULSION_FOR_EACH_FIXED_CHANNEL_COUNT(macro) macro(3) macro(4) macro(8) macro(64)

/// Expands macro(N) for each number of values that a path may carry.
#define EMULSION_FOR_EACH_CHANNEL_COUNT(macro) EMULSION_FOR_EACH_WAVELENGTH_COUNT(macro) macro(3) macro(64)
