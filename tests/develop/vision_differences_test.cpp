// How far the fast loss of acuity is from its twin, as colours seen on a display: CIEDE2000, in which about 1 is just
// seen side by side. The picture is as dark as eyes see that blur, and then shown by photographic tone reproduction.

#include <algorithm>
#include <iostream>

#include <gtest/gtest.h>

#include "spectrum/ciede2000_difference.h"
#include "three_pictures.h"
#include "tonemap/luminance_statistics.h"
#include "tonemap/vision.h"

namespace emulsion {
namespace {

/// The first columns and rows, at a log-average: the twin takes a sum over the neighbourhood for each pixel.
Image<XYZ> part_of(const Image<XYZ>& scene, double log_average_cdm2) {
    Image<XYZ> part(std::min(60, scene.width()), std::min(50, scene.height()));
    for (int y = 0; y < part.height(); ++y) {
        for (int x = 0; x < part.width(); ++x) part(x, y) = scene(x, y);
    }
    const double now = luminance_statistics(part.view(), 0).log_average_cdm2;
    for (XYZ& pixel : part.pixels()) pixel = static_cast<float>(log_average_cdm2 / now) * pixel;
    return part;
}

Lab shown(const XYZd& pixel, double log_average_cdm2) {
    const double scaled = 0.18 / log_average_cdm2;
    return lab_from_xyz((scaled / (1.0 + scaled * std::max(pixel.y, 0.0))) * pixel, kWhiteD);
}

TEST(VisionDifferences, OfTheLossOfAcuityAreWithinTheTolerance) {
    for (const TestPicture& picture : three_pictures()) {
        for (const double cdm2 : {1e-3, 1e-1}) {
            for (const float fov : {5.0f, 20.0f}) {
                const Image<XYZ> scene = part_of(picture.scene, cdm2);
                const HumanVision vision{.fov = fov, .glare = 0.0f, .rods = 0.0f};
                const Image<XYZ> fast = see(vision, scene.view(), 0);
                const Image<XYZd> exact = see_reference(vision, scene.view());
                double mean = 0.0, most = 0.0;
                for (std::size_t i = 0; i < fast.pixels().size(); ++i) {
                    const XYZ& pixel = fast.pixels()[i];
                    const double here = difference(Ciede2000Difference{}, shown({pixel.x, pixel.y, pixel.z}, cdm2),
                                                   shown(exact.pixels()[i], cdm2));
                    mean += here / static_cast<double>(fast.pixels().size());
                    most = std::max(most, here);
                }
                std::cout << picture.name << ", " << cdm2 << " cd/m^2, " << fov << " degrees: CIEDE2000 " << mean
                          << " on average, at most " << most << "\n";
                EXPECT_LE(mean, 0.7);
                EXPECT_LE(most, 6.0);
            }
        }
    }
}

}  // namespace
}  // namespace emulsion
