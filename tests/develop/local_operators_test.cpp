// How far the fast local operators are from their twins, and from themselves on a picture that was turned, as colours
// seen on a display: CIEDE2000, in which about 1 is just seen side by side.

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "spectrum/ciede2000_difference.h"
#include "three_pictures.h"
#include "tonemap/tone_mapper.h"

namespace emulsion {
namespace {

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
    Differences twin;      ///< from the double-precision twin
    Differences mirrored;  ///< of a picture of odd size from the same mirrored
};

class LocalOperators : public testing::TestWithParam<Stated> {};

TEST_P(LocalOperators, AreWithinTheirToleranceOfTheTwin) {
    for (const TestPicture& picture : three_pictures()) {
        const Image<XYZd> exact = tone_map_reference({GetParam().mapper}, picture.scene.view(), kWhiteD);
        const Differences found = differences(exact, map(GetParam().mapper, picture.scene));
        EXPECT_LE(found.mean, GetParam().twin.mean) << picture.name;
        EXPECT_LE(found.max, GetParam().twin.max) << picture.name;
    }
}

// Sizes that halve evenly, as these three: rounding only.
TEST_P(LocalOperators, TurnAndMirrorWithThePicture) {
    for (const TestPicture& picture : three_pictures()) {
        const Image<XYZ> before = map(GetParam().mapper, picture.scene);
        EXPECT_LE(differences(turned(before), map(GetParam().mapper, turned(picture.scene))).max, 0.01) << picture.name;
        EXPECT_LE(differences(mirrored_picture(before), map(GetParam().mapper, mirrored_picture(picture.scene))).max,
                  0.01)
            << picture.name;
    }
}

TEST_P(LocalOperators, MirrorWithAPictureOfOddSizeNearly) {
    for (const TestPicture& picture : three_pictures()) {
        const Image<XYZ> scene = odd_part(picture.scene);
        const Image<XYZ> before = map(GetParam().mapper, scene);
        const Differences found =
            differences(mirrored_picture(before), map(GetParam().mapper, mirrored_picture(scene)));
        EXPECT_LE(found.mean, GetParam().mirrored.mean) << picture.name;
        EXPECT_LE(found.max, GetParam().mirrored.max) << picture.name;
    }
}

INSTANTIATE_TEST_SUITE_P(All, LocalOperators,
                         testing::Values(Stated{ReinhardLocal{}, {0.1, 2.0}, {0.1, 2.0}},
                                         Stated{HighContrast{}, {0.1, 2.5}, {0.1, 2.5}},
                                         Stated{Durand{5.0f}, {0.1, 1.0}, {0.001, 0.01}},
                                         Stated{LocalAdaptation{}, {0.05, 1.0}, {0.1, 3.5}}),
                         [](const auto& instance) {
                             std::string name = to_text(instance.param.mapper);
                             name.resize(std::min(name.size(), name.find(':')));
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace emulsion
