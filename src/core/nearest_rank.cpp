#include "core/nearest_rank.h"

#include <algorithm>
#include <cstddef>

namespace emulsion {

double nearest_rank(std::span<double> values, int percent) {
    if (values.empty()) return 0.0;
    const std::size_t rank = (values.size() * static_cast<std::size_t>(percent) + 99) / 100;
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(rank, 1) - 1);
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

}  // namespace emulsion
