#pragma once
// Standard observers: colour-matching functions xbar, ybar, zbar, dimensionless, tabulated at 1 nm.
//
// Integrals "over the observer's range" (spectrum/colorimetry.h) run from first_nm to last_nm. The range differs: the
// 2015 functions start at 390 nm, where zbar is 1% of its peak; light of shorter wavelengths doesn't count for them.

#include <string>
#include <string_view>
#include <vector>

#include "core/color.h"

namespace emulsion {

/// Colour-matching functions at first_nm, first_nm + 1, ...; straight lines between them and 0 outside.
struct Observer {
    std::string name;
    int first_nm = 0;
    std::vector<XYZd> value;  ///< at least two

    [[nodiscard]] int last_nm() const noexcept { return first_nm + static_cast<int>(value.size()) - 1; }
};

/// CIE 1931 standard observer, 2 degrees, 360-830 nm. Source: CIE 15:2004, ISO/CIE 11664-1.
[[nodiscard]] const Observer& cie_1931_2deg();

/// CIE 1964 standard observer, 10 degrees, 360-830 nm. Source: CIE 15:2004, ISO/CIE 11664-1.
[[nodiscard]] const Observer& cie_1964_10deg();

/// Functions transformed from the cone fundamentals, 2 degrees, 390-830 nm. Source: CIE 170-2:2015.
[[nodiscard]] const Observer& cie_2015_2deg();

/// An observer by one of observer_names(), by its year ("1931"), or by year and field ("1964 10deg"). Case makes no
/// difference, nor do '-', '_' and the space for one another.
/// \throws std::invalid_argument for an unknown name, listing the names that exist, nearest first.
[[nodiscard]] const Observer& observer(std::string_view name);

/// "cie_1931_2deg", "cie_1964_10deg", "cie_2015_2deg".
[[nodiscard]] std::vector<std::string_view> observer_names();

/// (xbar, ybar, zbar) at one wavelength; 0 outside the table.
[[nodiscard]] XYZd eval(const Observer& observer, double lambda_nm) noexcept;

}  // namespace emulsion
