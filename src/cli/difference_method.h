#pragma once

#include <utility>
#include <variant>

#include "spectrum/color_difference.h"
#include "spectrum/itp_difference.h"

namespace emulsion::cli {

template <class... Ts>
auto with_itp(const std::variant<Ts...>&) -> std::variant<Ts..., ItpDifference>;

/// What `emulsion color difference` can measure: the differences of CIELAB colours, and that of ICtCp colours.
using DifferenceMethod = decltype(with_itp(std::declval<ColorDifference>()));

}  // namespace emulsion::cli
