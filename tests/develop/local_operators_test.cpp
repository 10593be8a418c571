// How far the fast local operators are from their twins, and from themselves on a picture that was turned, as colours
// seen on a display: CIEDE2000, in which about 1 is just seen side by side.

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "film/exr_file.h"
#include "spectrum/ciede2000_difference.h"
#include "tonemap/tone_mapper.h"

namespace emulsion {
namespace {

constexpr XYZ kWhite{0.9504559f, 1.0f, 1.0890578f};
constexpr XYZd kWhiteD{kWhite.x, kWhite.y, kWhite.z};

struct TestPicture {
    std::string_view name;
    Image<XYZ> scene;
};

/// A room as path tracers show it: planes, soft shading, a lamp of 1 : 1000 with hard edges, and some noise.
Image<XYZ> synthetic_room() {
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

const std::vector<TestPicture>& pictures() {
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

/// As a display shows it: what is above white is scaled down to it.
Lab shown(const XYZd& pixel) { return lab_from_xyz((1.0 / std::max(pixel.y, 1.0)) * pixel, kWhiteD); }
Lab shown(const XYZ& pixel) { return shown(XYZd{pixel.x, pixel.y, pixel.z}); }

struct Differences {
    double mean = 0.0, max = 0.0;
};

template <class A, class B>
Differences differences(const Image<A>& one, const Image<B>& other) {
    Differences result;
    for (std::size_t i = 0; i < one.pixels().size(); ++i) {
        const double here = difference(Ciede2000Difference{}, shown(one.pixels()[i]), shown(other.pixels()[i]));
        result.mean += here / static_cast<double>(one.pixels().size());
        result.max = std::max(result.max, here);
    }
    return result;
}

Image<XYZ> map(const ToneMapper& mapper, const Image<XYZ>& scene) {
    return tone_map({mapper}, scene.view(), kWhite, 0).image;
}

/// By 90 degrees.
Image<XYZ> turned(const Image<XYZ>& image) {
    Image<XYZ> result(image.height(), image.width());
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) result(image.height() - 1 - y, x) = image(x, y);
    }
    return result;
}

Image<XYZ> mirrored_picture(const Image<XYZ>& image) {
    Image<XYZ> result(image.width(), image.height());
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) result(image.width() - 1 - x, y) = image(x, y);
    }
    return result;
}

/// The first pixels of every row and column, so that no size is even.
Image<XYZ> odd_part(const Image<XYZ>& image) {
    Image<XYZ> result(image.width() - 1, image.height() - 3);
    for (int y = 0; y < result.height(); ++y) {
        for (int x = 0; x < result.width(); ++x) result(x, y) = image(x, y);
    }
    return result;
}

/// An operator and what its header states.
struct Stated {
    ToneMapper mapper;
    Differences twin;  ///< from the double-precision twin
};

class LocalOperators : public testing::TestWithParam<Stated> {};

TEST_P(LocalOperators, AreWithinTheirToleranceOfTheTwin) {
    for (const TestPicture& picture : pictures()) {
        const Image<XYZd> exact = tone_map_reference({GetParam().mapper}, picture.scene.view(), kWhiteD);
        const Differences found = differences(exact, map(GetParam().mapper, picture.scene));
        EXPECT_LE(found.mean, GetParam().twin.mean) << picture.name;
        EXPECT_LE(found.max, GetParam().twin.max) << picture.name;
    }
}

void expect_turns_and_mirrors(const ToneMapper& mapper, const Image<XYZ>& scene, std::string_view name) {
    const Image<XYZ> before = map(mapper, scene);
    EXPECT_LE(differences(turned(before), map(mapper, turned(scene))).max, 0.01) << name;
    EXPECT_LE(differences(mirrored_picture(before), map(mapper, mirrored_picture(scene))).max, 0.01) << name;
}

// Rounding only.
TEST_P(LocalOperators, TurnAndMirrorWithThePicture) {
    for (const TestPicture& picture : pictures()) {
        expect_turns_and_mirrors(GetParam().mapper, picture.scene, picture.name);
    }
}

// No size is even, nor are most of the smaller pictures'.
TEST_P(LocalOperators, TurnAndMirrorWithAPictureOfOddSize) {
    for (const TestPicture& picture : pictures()) {
        const Image<XYZ> scene = odd_part(picture.scene);
        expect_turns_and_mirrors(GetParam().mapper, scene, picture.name);
    }
}

INSTANTIATE_TEST_SUITE_P(All, LocalOperators,
                         testing::Values(Stated{ReinhardLocal{}, {0.1, 2.0}}, Stated{HighContrast{}, {0.1, 2.5}},
                                         Stated{Durand{5.0f}, {0.1, 1.0}}, Stated{LocalAdaptation{}, {0.05, 1.0}}),
                         [](const auto& instance) {
                             std::string name = to_text(instance.param.mapper);
                             name.resize(std::min(name.size(), name.find(':')));
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace emulsion
