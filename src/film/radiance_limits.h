#pragma once
// Widths of Radiance pictures that may have run lengths of the new kind.

#include <cstddef>

namespace emulsion {

inline constexpr std::size_t kLeastRunWidth = 8, kMostRunWidth = 32767;

}  // namespace emulsion
