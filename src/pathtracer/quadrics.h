#pragma once
// The quadrics as one type: to add one, write its file and put it into the variant.

#include <variant>

#include "pathtracer/cylinder.h"
#include "pathtracer/disk.h"
#include "pathtracer/sphere.h"

namespace emulsion {

using PreparedQuadric = std::variant<PreparedSphere, PreparedDisk, PreparedCylinder>;

[[nodiscard]] inline PreparedQuadric prepared(const Sphere& sphere) { return PreparedSphere(sphere); }
[[nodiscard]] inline PreparedQuadric prepared(const Disk& disk) { return PreparedDisk(disk); }
[[nodiscard]] inline PreparedQuadric prepared(const Cylinder& cylinder) { return PreparedCylinder(cylinder); }

[[nodiscard]] inline QuadricPoint point_at(const PreparedQuadric& quadric, const Imath::V3d& near_surface) noexcept {
    return std::visit([&](const auto& q) { return point_at(q, near_surface); }, quadric);
}

}  // namespace emulsion
