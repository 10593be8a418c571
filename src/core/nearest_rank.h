#pragma once

#include <span>

namespace emulsion {

/// The least of the values that `percent` in a hundred of them do not exceed: one of the values itself, exact, for
/// percentages of 1 to 100. 0 if there are none. The values, none of which is NaN, change places.
[[nodiscard]] double nearest_rank(std::span<double> values, int percent);

}  // namespace emulsion
