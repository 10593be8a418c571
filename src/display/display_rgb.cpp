#include "display/display_rgb.h"

#include <array>
#include <cstddef>
#include <variant>

#include "spectrum/rgb_space.h"

namespace emulsion {

RgbFromXyz rgb_from_xyz(const Display& display, const SceneWhite& white) {
    validate(display);
    validate(white, display);
    Matrix3 matrix = rgb_from_xyz(rgb_space(display));
    if (!std::holds_alternative<AsItIs>(white)) matrix = matrix * display_from_scene(white, display);
    const SignalScale scale = signal_scale(light_of(display));
    for (auto& row : matrix.m) {
        for (double& element : row) element *= scale.gain;
    }
    return {matrix, scale.pedestal};
}

RGBd display_rgb(const RgbFromXyz& conversion, const XYZd& xyz) noexcept {
    const auto rgb = conversion.matrix * std::array<double, 3>{xyz.x, xyz.y, xyz.z};
    return {rgb[0] - conversion.pedestal, rgb[1] - conversion.pedestal, rgb[2] - conversion.pedestal};
}

void display_rgb(const RgbFromXyz& conversion, std::span<const XYZ> xyz, std::span<RGB> rgb) noexcept {
    std::array<std::array<float, 3>, 3> m{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            m[row][column] = static_cast<float>(conversion.matrix.m[row][column]);
        }
    }
    // Component by component: GCC 12 makes no vectors of loops that copy whole pixels.
    for (std::size_t i = 0; i < xyz.size(); ++i) {
        const float x = xyz[i].x, y = xyz[i].y, z = xyz[i].z;
        rgb[i].r = m[0][0] * x + m[0][1] * y + m[0][2] * z;
        rgb[i].g = m[1][0] * x + m[1][1] * y + m[1][2] * z;
        rgb[i].b = m[2][0] * x + m[2][1] * y + m[2][2] * z;
    }
    const auto pedestal = static_cast<float>(conversion.pedestal);
    if (pedestal == 0.0f) return;
    for (RGB& p : rgb) p = {p.r - pedestal, p.g - pedestal, p.b - pedestal};
}

}  // namespace emulsion
