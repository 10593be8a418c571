// Three numbers in the place of a spectrum: what two reflections leave of a light.

#include <algorithm>
#include <cstddef>

#include <gtest/gtest.h>

#include "colour_math.h"
#include "film/sensor.h"
#include "patch_products.h"
#include "spectrum/rgb_space.h"
#include "spectrum/rgb_uplift.h"
#include "spectrum/wavelength_sampling.h"

namespace emulsion::stability {
namespace {

void expect_differences(const TransportModel& model, const Spectrum& light, double mean, double largest) {
    const Differences found = differences(pair_products(model, light));
    EXPECT_NEAR(found.mean, mean, 0.05) << to_text(model);
    EXPECT_NEAR(found.largest, largest, 0.1) << to_text(model);
}

// (E R1 R2) as RGB is not RGB(E R1) RGB(R2): the mean of a product is not the product of means.
TEST(RgbProducts, OfColorCheckerPairsUnderD65) {
    const Spectrum d65 = catalogue_spectrum("D65");
    expect_differences(RgbModel{}, d65, 3.87, 34.4);
    expect_differences(RgbModel{"Rec2020"}, d65, 1.86, 12.6);
    expect_differences(RgbModel{"ACEScg"}, d65, 1.85, 12.0);
    expect_differences(PrefilteredRgbModel{}, d65, 2.12, 12.2);
    expect_differences(BasisModel{6}, d65, 0.79, 8.2);
    expect_differences(BasisModel{8}, d65, 0.44, 1.7);
}

/// The worst pair by paths of four wavelengths: no bias, and a noise that falls with their number.
TEST(RgbProducts, AreWhatTheyShouldBeByWavelengths) {
    const Spectrum d65 = catalogue_spectrum("D65"), red = catalogue_spectrum("colorchecker-red"),
                   cyan = catalogue_spectrum("colorchecker-cyan");
    const XYZd exact = xyz_of_reflectance(product_of(red, cyan), d65);
    const double white_luminance = xyz_of_radiance(d65).y;
    const Sensor sensor;
    constexpr int kPaths = 4096;
    XYZd sum;
    for (int i = 0; i < kPaths; ++i) {
        const auto path = hero_wavelengths<4>(VisibleWavelengthPdf{}, (static_cast<float>(i) + 0.5f) / kPaths);
        SampledSpectrum<4> radiance;
        for (std::size_t k = 0; k < 4; ++k) {
            const auto nm = static_cast<double>(path.lambda_nm[k]);
            radiance.value[k] = static_cast<float>(eval(d65, nm) * eval(red, nm) * eval(cyan, nm));
        }
        sum = sum + 1.0 / (kPaths * white_luminance) * sensor.to_xyz_reference(path, radiance);
    }
    EXPECT_LT(ciede2000(exact, sum, xyz_of_reflectance(ConstantSpectrum{1.0}, d65)), 0.01);
}

// Where the mean of 3.9 and the largest of 34 depend on what is counted: with X, Y and Z below 0 left as they are, and
// over all patches. The worst pair is red and cyan, whose red is negative.
TEST(RgbProducts, DifferWithNegativeLightAndWithGreys) {
    const Spectrum d65 = catalogue_spectrum("D65");
    const PairProducts products = pair_products(RgbModel{}, d65);
    double mean = 0.0, largest = 0.0;
    for (const Product& p : products.pair) {
        const double d = ciede2000(p.spectral, p.model, products.white);
        mean += d / 153.0;
        largest = std::max(largest, d);
    }
    EXPECT_NEAR(mean, 3.88, 0.01);
    EXPECT_NEAR(largest, 37.0, 0.05);
    EXPECT_NEAR(differences(pair_products(RgbModel{}, d65, kAllPatches)).mean, 2.17, 0.01);
    EXPECT_LT(RgbUplift(rgb_space("Rec709")).rgb_of(catalogue_spectrum("colorchecker-cyan")).r, 0.0);
}

TEST(RgbProducts, UnderAFluorescentTube) {
    const Spectrum tube = catalogue_spectrum("FL11");
    expect_differences(RgbModel{}, tube, 5.74, 40.6);
    expect_differences(RgbModel{"Rec2020"}, tube, 3.13, 10.2);
    expect_differences(RgbModel{"ACEScg"}, tube, 2.96, 10.3);
    expect_differences(BasisModel{6}, tube, 0.79, 7.4);
    expect_differences(PrefilteredRgbModel{}, tube, 1.81, 9.6);
    expect_differences(BasisModel{8}, tube, 0.23, 2.0);
}

}  // namespace
}  // namespace emulsion::stability
