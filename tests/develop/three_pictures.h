#pragma once
// The three pictures on which tone mapping is measured: two crops of photographs (tests/data) and a synthetic room.

#include <filesystem>
#include <string_view>
#include <vector>

#include "core/color.h"
#include "core/image.h"
#include "film/exr_file.h"

namespace emulsion {

/// Of D65, and so of the photographs' grey.
inline constexpr XYZ kWhite{0.9504559f, 1.0f, 1.0890578f};
inline constexpr XYZd kWhiteD{kWhite.x, kWhite.y, kWhite.z};

struct TestPicture {
    std::string_view name;
    Image<XYZ> scene;
};

/// A room as path tracers show it: planes, soft shading, a lamp of 1 : 1000 with hard edges, and some noise.
inline Image<XYZ> synthetic_room() {
    Image<XYZ> scene(192, 160);
    for (int y = 0; y < scene.height(); ++y) {
        for (int x = 0; x < scene.width(); ++x) {
            const bool is_lamp = x >= 70 && x < 120 && y >= 12 && y < 24;
            const bool is_box = x >= 30 && x < 80 && y >= 80 && y < 140;
            const float fall_off =
                1.0f / (1.0f + 0.0005f * static_cast<float>((x - 95) * (x - 95) + (y - 18) * (y - 18)));
            const float noise = 1.0f + 0.04f * static_cast<float>((x * 7919 + y * 104729) % 11 - 5) / 5.0f;
            const float luminance = (is_lamp ? 2000.0f : is_box ? 0.4f : 12.0f) * fall_off * noise;
            scene(x, y) = x < 40 ? XYZ{1.6f * luminance, luminance, 0.4f * luminance} : luminance * kWhite;
        }
    }
    return scene;
}

inline const std::vector<TestPicture>& three_pictures() {
    static const std::vector<TestPicture> all = [] {
        const std::filesystem::path data = std::filesystem::path(EMULSION_SOURCE_DIR) / "tests/data";
        std::vector<TestPicture> result;
        result.push_back({"desk", read_exr(data / "desk_crop.exr").xyz});
        result.push_back({"venice", read_exr(data / "venice_crop.exr").xyz});
        result.push_back({"room", synthetic_room()});
        return result;
    }();
    return all;
}

}  // namespace emulsion
