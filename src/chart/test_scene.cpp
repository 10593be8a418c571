#include "chart/test_scene.h"

#include <cmath>
#include <cstdint>

#include "core/random.h"

namespace emulsion {

Image<XYZ> chart_scene(int width_px, int height_px) {
    Image<XYZ> scene(width_px, height_px);
    for (int y = 0; y < height_px; ++y) {
        Pcg32 random(static_cast<std::uint64_t>(y));
        for (int x = 0; x < width_px; ++x) {
            const float u = static_cast<float>(x) / static_cast<float>(width_px);
            const float v = static_cast<float>(y) / static_cast<float>(height_px);
            const auto step = static_cast<float>((static_cast<int>(5.0f * u) + static_cast<int>(4.0f * v)) % 4) - 1.5f;
            const float slope = 0.5f * std::sin(9.0f * u + 4.0f * v) * std::cos(7.0f * v - 2.0f * u);
            const float luminance = std::pow(10.0f, step + slope);
            const auto noise = [&] { return 1.0f + 0.1f * (random.next_float() + random.next_float() - 1.0f); };
            scene(x, y) = {(0.85f + 0.2f * v) * luminance * noise(), luminance * noise(),
                           (0.7f + 0.6f * u) * luminance * noise()};
        }
    }
    return scene;
}

}  // namespace emulsion
