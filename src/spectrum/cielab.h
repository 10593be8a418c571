#pragma once
// CIELAB; colour differences in it are in spectrum/color_difference.h. XYZ and white are relative or absolute, but both
// the same.

#include "core/color.h"

namespace emulsion {

/// L* is 100 for white; a* > 0 is reddish, b* > 0 yellowish.
struct Lab {
    double l = 0.0, a = 0.0, b = 0.0;
    bool operator==(const Lab&) const = default;
};

/// Source: CIE 15:2004, section 8.2.1, with the linear toe below (6/29)^3, which also takes negative XYZ.
[[nodiscard]] Lab lab_from_xyz(const XYZd& xyz, const XYZd& white) noexcept;

}  // namespace emulsion
