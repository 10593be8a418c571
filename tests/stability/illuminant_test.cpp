// Reflectances, lights, and the light that both were taken under.

#include <array>
#include <cstddef>

#include <gtest/gtest.h>

#include "colour_math.h"
#include "core/matrix3.h"
#include "pathtracer/model_channels.h"
#include "spectrum/catalogue.h"
#include "spectrum/colorimetry.h"
#include "spectrum/rgb_space.h"
#include "spectrum/rgb_uplift.h"

namespace emulsion::stability {
namespace {

// RGB of a light is that of light; a reflectance of that colour looks so under the space's white. A lamp that is made
// of the light's spectrum and seen as a reflectance has that white twice; one that is made of the reflectance alone
// has it not at all, and is the pinkish white of equal energy.
TEST(Illuminant, CountedTwiceOrNotAtAll) {
    const RgbUplift srgb(rgb_space("sRGB"));
    const Spectrum d65 = srgb.illuminant();
    const RGBd grey{0.5, 0.5, 0.5};
    const XYZd white = xyz_of_reflectance(ConstantSpectrum{1.0}, d65);
    const auto seen = [](const Spectrum& radiance) {
        const XYZd xyz = xyz_of_radiance(radiance);
        return 0.5 / xyz.y * xyz;
    };
    const Spectrum reflectance = srgb.reflectance(grey), light = srgb.light(grey);
    EXPECT_NEAR(ciede2000(0.5 * white, seen(product_of(light, d65)), white), 8.46, 0.05);
    EXPECT_NEAR(ciede2000(0.5 * white, seen(reflectance), white), 8.88, 0.05);
    EXPECT_LT(ciede2000(0.5 * white, seen(light), white), 0.01);
    EXPECT_LT(ciede2000(0.5 * white, seen(product_of(reflectance, d65)), white), 0.01);
    EXPECT_NEAR(xyz_of_radiance(light).y / (683.002 * srgb.light_normalisation()), 0.5, 1e-4);
}

// --- Metamers

/// A grey, and another that looks alike under D65: the grey with bumps whose colours cancel.
TEST(Metamers, AreOneColourInRgbUnderEveryLight) {
    const Spectrum d65 = illuminant_of(rgb_space("sRGB")), a = catalogue_spectrum("A");
    const auto bump = [](double nm) { return Spectrum(LineSpectrum{{}, {GaussianLine{nm, 30.0, 8.0}}}); };
    Matrix3 xyz_of_bumps;
    const std::array<double, 3> at_nm = {450.0, 540.0, 610.0};
    for (std::size_t k = 0; k < 3; ++k) {
        const XYZd xyz = xyz_of_reflectance(bump(at_nm[k]), d65);
        xyz_of_bumps.m[0][k] = xyz.x, xyz_of_bumps.m[1][k] = xyz.y, xyz_of_bumps.m[2][k] = xyz.z;
    }
    const XYZd yellow = xyz_of_reflectance(bump(575.0), d65);
    const std::array<double, 3> cancel = inverse(xyz_of_bumps) * std::array{-yellow.x, -yellow.y, -yellow.z};
    const Spectrum grey = ConstantSpectrum{0.4};
    SumSpectrum other{{grey, bump(575.0)}, {1.0, 1.0}};
    for (std::size_t k = 0; k < 3; ++k) {
        other.term.push_back(bump(at_nm[k]));
        other.weight.push_back(cancel[k]);
    }
    for (int nm = 380; nm <= 780; ++nm) {
        EXPECT_GT(eval(Spectrum(other), nm), 0.0) << nm;
        EXPECT_LT(eval(Spectrum(other), nm), 1.0) << nm;
    }
    const XYZd white_a = xyz_of_reflectance(ConstantSpectrum{1.0}, a);
    const double under_d65 = ciede2000(xyz_of_reflectance(grey, d65), xyz_of_reflectance(other, d65),
                                       xyz_of_reflectance(ConstantSpectrum{1.0}, d65));
    const double under_a = ciede2000(xyz_of_reflectance(grey, a), xyz_of_reflectance(other, a), white_a);
    EXPECT_LT(under_d65, 1e-6);
    EXPECT_NEAR(under_a, 5.53, 0.05);

    // By channels: what the two reflect of A.
    const auto by_model = [&](const TransportModel& model) {
        const FixedChannels channels = *channels_of(model, {{{a, 1.0}}, {grey, Spectrum(other)}});
        const ChannelValues lamp = light_values(channels, a);
        const auto look = [&](const Spectrum& reflectance) {
            const ChannelValues r = property_values(channels, reflectance);
            XYZd sum;
            for (std::size_t k = 0; k < channels.size(); ++k) {
                sum = sum + lamp[k] * r[k] * XYZd{channels[k].xyz[0], channels[k].xyz[1], channels[k].xyz[2]};
            }
            return 1.0 / xyz_of_radiance(a).y * sum;
        };
        return ciede2000(look(grey), look(other), white_a);
    };
    EXPECT_NEAR(by_model(RgbModel{}), 0.0, 0.05);
    EXPECT_NEAR(by_model(PrefilteredRgbModel{}), under_a, 0.05);
    EXPECT_NEAR(by_model(BasisModel{6}), under_a, 0.05);
}

}  // namespace
}  // namespace emulsion::stability
