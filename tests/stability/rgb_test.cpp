// Three numbers in the place of a spectrum: products, colours outside the gamut, uplifts, metamers.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/matrix3.h"
#include "display/gamut_mapper.h"
#include "film/sensor.h"
#include "patch_products.h"
#include "spectrum/cielab.h"
#include "spectrum/integral.h"
#include "spectrum/observer.h"
#include "spectrum/rgb_space.h"
#include "spectrum/rgb_uplift.h"
#include "spectrum/sigmoid.h"
#include "spectrum/wavelength_sampling.h"

namespace emulsion::stability {
namespace {

double ciede2000(const XYZd& a, const XYZd& b, const XYZd& white) {
    return difference(Ciede2000Difference{}, lab_from_xyz(a, white), lab_from_xyz(b, white));
}
RGBd times(const Matrix3& m, const XYZd& xyz) {
    const std::array<double, 3> p = m * std::array{xyz.x, xyz.y, xyz.z};
    return {p[0], p[1], p[2]};
}
XYZd times(const Matrix3& m, const RGBd& rgb) {
    const std::array<double, 3> p = m * std::array{rgb.r, rgb.g, rgb.b};
    return {p[0], p[1], p[2]};
}

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

// --- Negative components

TEST(NegativeRgb, OfEveryMonochromaticLight) {
    int inside_rec709 = 0, inside_rec2020 = 0;
    for (int nm = 400; nm <= 700; ++nm) {
        const XYZd xyz = eval(cie_1931_2deg(), nm);
        const auto is_inside = [&xyz](const char* space) {
            const RGBd rgb = times(rgb_from_xyz(rgb_space(space)), xyz);
            return std::min({rgb.r, rgb.g, rgb.b}) >= 0.0;
        };
        inside_rec709 += is_inside("Rec709") ? 1 : 0;
        inside_rec2020 += is_inside("Rec2020") ? 1 : 0;
    }
    EXPECT_EQ(inside_rec709, 0);
    // Those of its primaries, of which two are whole nanometres.
    EXPECT_EQ(inside_rec2020, 2);
}

/// Paths of one wavelength each, evenly over the spectrum of equal energy: their mean is a white. Kept in RGB, with
/// what is below 0 clipped away path by path, it is not.
TEST(NegativeRgb, ClippedBeforeTheSumIsAnotherColour) {
    const Matrix3 rgb_of = rgb_from_xyz(rgb_space("Rec709")), xyz_of = xyz_from_rgb(rgb_space("Rec709"));
    RGBd clipped;
    XYZd sum;
    for (int nm = 360; nm <= 830; ++nm) {
        const XYZd xyz = eval(cie_1931_2deg(), nm);
        const RGBd rgb = times(rgb_of, xyz);
        clipped = clipped + RGBd{std::max(rgb.r, 0.0), std::max(rgb.g, 0.0), std::max(rgb.b, 0.0)};
        sum = sum + xyz;
    }
    const XYZd naive = times(xyz_of, clipped), white = 1.0 / sum.y * sum;
    EXPECT_NEAR(naive.y / sum.y, 1.195, 0.001);
    EXPECT_NEAR(ciede2000(0.5 * white, 0.5 / sum.y * naive, white), 9.04, 0.05);
    // A film of X, Y and Z has nothing below 0 to clip.
    for (int nm = 360; nm <= 830; ++nm) {
        const XYZd xyz = eval(cie_1931_2deg(), nm);
        EXPECT_GE(std::min({xyz.x, xyz.y, xyz.z}), 0.0) << nm;
    }
}

/// Light of 520 nm at a fifth of white, shown by Rec. 709.
TEST(NegativeRgb, ClippedOnTheDisplayChangesLuminance) {
    const DisplayGamut display = display_gamut(SrgbDisplay{});
    const XYZd locus = eval(cie_1931_2deg(), 520.0);
    const RGBd rgb = times(rgb_from_xyz(rgb_space("sRGB")), 0.2 / locus.y * locus);
    EXPECT_NEAR(rgb.r, -0.261, 0.001);
    const auto luminance = [&](const GamutMapper& mapper) {
        const RGBd shown = map_gamut(mapper, display, rgb);
        return times(xyz_from_rgb(rgb_space("sRGB")), shown).y;
    };
    EXPECT_NEAR(luminance(GamutClip{}) / 0.2, 1.283, 0.001);
    EXPECT_NEAR(luminance(GamutDesaturate{}) / 0.2, 1.0, 1e-6);
}

// --- Uplifts

/// The reflectance c0 + c1 cos t + c2 sin t, t once round over 400 to 700 nm, that has the colour: three linear
/// equations. Source: Glassner, "How to Derive a Spectrum from an RGB Triplet", IEEE CG&A 9(4), 1989.
PiecewiseLinearSpectrum linear_uplift(const RgbUplift& space, const RGBd& rgb) {
    const auto wave = [](const std::array<double, 3>& c) {
        PiecewiseLinearSpectrum spectrum;
        for (int nm = 360; nm <= 830; ++nm) {
            const double t = 2.0 * M_PI * std::clamp((nm - 400.0) / 300.0, 0.0, 1.0);
            spectrum.lambda_nm.push_back(nm);
            spectrum.value.push_back(c[0] + c[1] * std::cos(t) + c[2] * std::sin(t));
        }
        return spectrum;
    };
    Matrix3 rgb_from_c;
    for (std::size_t k = 0; k < 3; ++k) {
        std::array<double, 3> unit{};
        unit[k] = 1.0;
        const RGBd column = space.rgb_of(wave(unit));
        rgb_from_c.m[0][k] = column.r, rgb_from_c.m[1][k] = column.g, rgb_from_c.m[2][k] = column.b;
    }
    return wave(inverse(rgb_from_c) * std::array{rgb.r, rgb.g, rgb.b});
}

double distance(const RGBd& a, const RGBd& b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

// At the boundary of the gamut the linear answer is no reflectance: it takes more light away than there is, and gives
// light that was not there.
TEST(Uplift, LinearOneAtTheBoundaryIsNoReflectance) {
    const RgbUplift srgb(rgb_space("sRGB"));
    const PiecewiseLinearSpectrum red = linear_uplift(srgb, {1.0, 0.0, 0.0}),
                                  cyan = linear_uplift(srgb, {0.0, 1.0, 1.0});
    EXPECT_NEAR(*std::min_element(red.value.begin(), red.value.end()), -0.213, 0.001);
    EXPECT_NEAR(*std::max_element(cyan.value.begin(), cyan.value.end()), 1.213, 0.001);
    for (int corner = 0; corner < 8; ++corner) {
        const RGBd rgb{corner & 1 ? 1.0 : 0.0, corner & 2 ? 1.0 : 0.0, corner & 4 ? 1.0 : 0.0};
        const Spectrum ours = srgb.reflectance(rgb);
        for (int nm = 360; nm <= 830; ++nm) {
            const double value = eval(ours, nm);
            EXPECT_TRUE(value >= 0.0 && value <= 1.0) << corner << ", " << nm;
        }
        EXPECT_LT(distance(srgb.rgb_of(ours), rgb), 1e-6) << corner;
    }
}

// The sigmoid as published, 1/2 + x / (2 sqrt(1 + x^2)), takes two numbers that are nearly one from each other where
// reflectances are small: in single precision what is left has steps of 3e-8.
TEST(Uplift, SigmoidAsPublishedLosesTheDark) {
    const auto published = [](float x) { return 0.5f + x / (2.0f * std::sqrt(1.0f + x * x)); };
    const auto relative_error = [](float found, double value) {
        return std::abs(static_cast<double>(found) / value - 1.0);
    };
    double naive = 0.0, ours = 0.0;
    for (int i = 0; i < 1000; ++i) {
        const double value = 1e-6 * (1.0 + 1e-3 * i);
        const auto x = static_cast<float>(inverse_sigmoid(value));
        const double exact = sigmoid(static_cast<double>(x));
        naive = std::max(naive, relative_error(published(x), exact));
        ours = std::max(ours, relative_error(sigmoid(x), exact));
    }
    EXPECT_NEAR(naive, 0.034, 0.002);
    EXPECT_LT(ours, 1e-6);
    EXPECT_EQ(published(static_cast<float>(inverse_sigmoid(1e-8))), 0.0f);
    // And all the way from RGB: black and colours near it keep their ratios.
    const RgbUplift srgb(rgb_space("sRGB"));
    const RGBd dark{1e-6, 2e-6, 5e-7};
    EXPECT_LT(distance(srgb.rgb_of(srgb.reflectance(dark)), dark), 1e-12);
    EXPECT_EQ(eval(srgb.reflectance({}), 550.0), 0.0);
}

// --- Illuminants

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
