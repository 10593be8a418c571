// How far the fast operators are from their twins, and from themselves on a picture that was turned, as colours seen on
// a display: CIEDE2000, in which about 1 is just seen side by side.

#include <algorithm>
#include <iostream>
#include <string>
#include <string_view>
#include <variant>
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

void expect_within(const Differences& stated, const Differences& found, std::string_view picture) {
    std::cout << "CIEDE2000, " << picture << ": " << found.mean << " on average, at most " << found.max << "\n";
    EXPECT_LE(found.mean, stated.mean) << picture;
    EXPECT_LE(found.max, stated.max) << picture;
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

/// What tone_map_reference() states.
struct Stated {
    Differences twin;      ///< from the double-precision twin
    Differences mirrored;  ///< of a picture of odd size from the same mirrored
};

/// Operators that adapt to each pixel's surroundings are approximated. The others differ by the steps of a table, 2e-4
/// of a luminance: 0.008 in the L* of white.
Stated stated(const ToneMapper& mapper) {
    if (std::holds_alternative<ReinhardLocal>(mapper)) return {{0.1, 2.0}, {0.1, 2.0}};
    if (std::holds_alternative<HighContrast>(mapper)) return {{0.1, 2.5}, {0.1, 2.5}};
    if (std::holds_alternative<Durand>(mapper)) return {{0.1, 1.0}, {0.001, 0.01}};
    if (std::holds_alternative<LocalAdaptation>(mapper)) return {{0.05, 1.0}, {0.1, 3.5}};
    return {{0.001, 0.01}, {0.001, 0.01}};
}

class OperatorDifferences : public testing::TestWithParam<ToneMapper> {};

TEST_P(OperatorDifferences, FromTheTwinAreWithinTheTolerance) {
    for (const TestPicture& picture : three_pictures()) {
        const Image<XYZd> exact = tone_map_reference({GetParam()}, picture.scene.view(), kWhiteD);
        expect_within(stated(GetParam()).twin, differences(exact, map(GetParam(), picture.scene)), picture.name);
    }
}

// Sizes that halve evenly, as these three: rounding only.
TEST_P(OperatorDifferences, AreNoneWhenThePictureTurns) {
    for (const TestPicture& picture : three_pictures()) {
        const Image<XYZ> before = map(GetParam(), picture.scene);
        EXPECT_LE(differences(turned(before), map(GetParam(), turned(picture.scene))).max, 0.01) << picture.name;
        EXPECT_LE(differences(mirrored_picture(before), map(GetParam(), mirrored_picture(picture.scene))).max, 0.01)
            << picture.name;
    }
}

TEST_P(OperatorDifferences, OfAMirroredPictureOfOddSizeAreWithinTheTolerance) {
    for (const TestPicture& picture : three_pictures()) {
        const Image<XYZ> scene = odd_part(picture.scene);
        const Image<XYZ> before = mirrored_picture(map(GetParam(), scene));
        expect_within(stated(GetParam()).mirrored, differences(before, map(GetParam(), mirrored_picture(scene))),
                      picture.name);
    }
}

std::vector<ToneMapper> all_mappers() {
    std::vector<ToneMapper> mappers;
    for_each_alternative<ToneMapper>([&](const auto& mapper) { mappers.emplace_back(mapper); });
    return mappers;
}

INSTANTIATE_TEST_SUITE_P(Variant, OperatorDifferences, testing::ValuesIn(all_mappers()), [](const auto& instance) {
    std::string name = to_text(instance.param);
    name.resize(std::min(name.size(), name.find(':')));
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

}  // namespace
}  // namespace emulsion
