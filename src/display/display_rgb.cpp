#include "display/display_rgb.h"

#include <array>
#include <cstddef>
#include <variant>

#include "display/display_rgb_rows.h"
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
    std::array<float, 9> matrix{};
    for (std::size_t i = 0; i < matrix.size(); ++i) matrix[i] = static_cast<float>(conversion.matrix.m[i / 3][i % 3]);
    linear_rgb(matrix, static_cast<float>(conversion.pedestal), xyz, rgb);
}

}  // namespace emulsion
