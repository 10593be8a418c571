#pragma once
// Standard observers: colour-matching functions xbar, ybar, zbar, dimensionless, tabulated at 1 nm.

#include <string>
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

/// CIE 1931 standard observer, 2 degrees, 360-830 nm. Source: CIE 15:2004.
[[nodiscard]] const Observer& cie_1931_2deg();

/// (xbar, ybar, zbar) at one wavelength; 0 outside the table.
[[nodiscard]] XYZd eval(const Observer& observer, double lambda_nm) noexcept;

}  // namespace emulsion
