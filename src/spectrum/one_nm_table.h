#pragma once
// Triples of functions tabulated at every whole nanometre: what the observers share.

#include <algorithm>
#include <cstddef>
#include <vector>

namespace emulsion {

/// The triple at one wavelength, of a table whose first row is at first_nm: straight lines between the rows, and zeros
/// outside the table. `value` has at least two rows.
template <class Triple>
[[nodiscard]] Triple value_at(int first_nm, const std::vector<Triple>& value, double lambda_nm) noexcept {
    const double above = lambda_nm - first_nm;
    const double last = static_cast<double>(value.size()) - 1.0;
    if (!(above >= 0.0 && above <= last)) return {};
    const auto i = std::min(static_cast<std::size_t>(above), value.size() - 2);
    const double t = above - static_cast<double>(i);
    return (1.0 - t) * value[i] + t * value[i + 1];
}

}  // namespace emulsion
