#include "display/display_rgb.h"

#include <cstddef>

#include "spectrum/rgb_space.h"

namespace emulsion {

namespace {

const RgbSpace& space_of(const SrgbDisplay& /*display*/) { return rgb_space("sRGB"); }

const RgbSpace& space_of(const Display& display) {
    return std::visit([](const auto& chosen) -> const RgbSpace& { return space_of(chosen); }, display);
}

}  // namespace

Matrix3 rgb_from_xyz(const Display& display) { return rgb_from_xyz(space_of(display)); }

XYZd white_xyz(const Display& display) { return xyz_of(space_of(display).white); }

RGBd display_rgb(const Matrix3& matrix, const XYZd& xyz) noexcept {
    const auto rgb = matrix * std::array<double, 3>{xyz.x, xyz.y, xyz.z};
    return {rgb[0], rgb[1], rgb[2]};
}

void display_rgb(const Matrix3& matrix, std::span<const XYZ> xyz, std::span<RGB> rgb) noexcept {
    std::array<std::array<float, 3>, 3> m{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            m[row][column] = static_cast<float>(matrix.m[row][column]);
        }
    }
    for (std::size_t i = 0; i < xyz.size(); ++i) {
        const XYZ p = xyz[i];
        rgb[i] = {m[0][0] * p.x + m[0][1] * p.y + m[0][2] * p.z, m[1][0] * p.x + m[1][1] * p.y + m[1][2] * p.z,
                  m[2][0] * p.x + m[2][1] * p.y + m[2][2] * p.z};
    }
}

}  // namespace emulsion
