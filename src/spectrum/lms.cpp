#include "spectrum/lms.h"

namespace emulsion {

Lms lms_of(const Matrix3& lms_from_xyz, const XYZd& xyz) noexcept {
    const auto [l, m, s] = lms_from_xyz * std::array{xyz.x, xyz.y, xyz.z};
    return {l, m, s};
}

XYZd xyz_of(const Matrix3& xyz_from_lms, const Lms& lms) noexcept {
    const auto [x, y, z] = xyz_from_lms * std::array{lms.l, lms.m, lms.s};
    return {x, y, z};
}

}  // namespace emulsion
