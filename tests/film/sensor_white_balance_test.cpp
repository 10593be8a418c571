#include "film/sensor_white_balance.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "core/named_value.h"
#include "film/film.h"
#include "sensor_fixture.h"
#include "spectrum/rgb_space.h"

namespace emulsion {
namespace {

using testing::every_sensor;
using testing::product;
using testing::seen_by;

/// Linear sRGB, as the stages behind the film have it.
XYZd srgb_of(const XYZd& xyz) { return product(rgb_from_xyz(rgb_space("sRGB")), xyz); }

void expect_grey(const XYZd& xyz, double tolerance, const std::string& what) {
    const XYZd rgb = srgb_of(xyz);
    EXPECT_NEAR(rgb.x, rgb.y, tolerance * rgb.y) << what;
    EXPECT_NEAR(rgb.z, rgb.y, tolerance * rgb.y) << what;
}

// Published to seven digits at brucelindbloom.com, "Chromatic Adaptation": Bradford from A to D65. There D65 is
// (0.95047, 1, 1.08883), here (0.95046, 1, 1.08906): 2e-4 of the largest element, 3.19, is 7e-4.
TEST(WhiteBalance, IsThePublishedAdaptation) {
    constexpr double kSum = 1.09850 + 1.0 + 0.35585;
    const WhiteBalance balance{Chromaticity{1.09850 / kSum, 1.0 / kSum}};
    const Matrix3 published{
        {{{0.8446965, -0.1179225, 0.3948108}, {-0.1366303, 1.1041226, 0.1291718}, {0.0798489, -0.1348999, 3.1924009}}}};
    const Matrix3 matrix = white_balance_matrix(balance, cie_1931_2deg());
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(matrix.m[i][j], published.m[i][j], 8e-4);
    }
}

// For every method: a grey patch under A is grey, and as light as it was.
TEST(WhiteBalance, GreyUnderAComesOutNeutral) {
    const Spectrum grey = scaled(catalogue_spectrum("A"), 0.18 / 683.0);
    const XYZd unbalanced = xyz_of_radiance(grey);
    EXPECT_GT(srgb_of(unbalanced).x, 2.0 * srgb_of(unbalanced).z);
    for_each_alternative<ChromaticAdaptation>([&](const auto& method) {
        const WhiteBalance balance{chromaticity_of(unbalanced), method};
        const Sensor sensor({.white_balance = balance});
        const XYZd xyz = seen_by(sensor, grey);
        expect_grey(xyz, 1e-9, std::string(method.kName));
        EXPECT_NEAR(xyz.y, unbalanced.y, 1e-9 * unbalanced.y) << method.kName;
    });
    // A is a blackbody of 2848 K on the scale with c2 = 1.435e-2 m K (CIE 15:2004), tabulated every 5 nm: straight
    // lines in between are up to 6e-4 above the curve.
    const double kelvin = 2848.0 * kSecondRadiation_mK / 1.435e-2;
    expect_grey(seen_by(Sensor({.white_balance = WhiteBalance{TemperatureWhite{kelvin}}}), grey), 2e-3, "2855.5 K");
}

// By temperature, a light comes out neutral for every observer and for a camera, which sees it in its own way.
TEST(WhiteBalance, ItsOwnLightIsNeutralToEverySensor) {
    for (auto [name, options] : every_sensor()) {
        for (const double kelvin : {1000.0, 2856.0, 3999.0, 4000.0, 9000.0, 25000.0}) {
            options.white_balance = WhiteBalance{TemperatureWhite{kelvin}};
            const Spectrum light = kelvin < 4000.0 ? Spectrum(BlackbodySpectrum{kelvin})
                                                   : Spectrum(DaylightSpectrum{kelvin, DaylightWeights::exact});
            expect_grey(seen_by(Sensor(options), light), 1e-9, name + " at " + std::to_string(kelvin));
        }
    }
}

TEST(WhiteBalance, FromTheWorkingWhiteIsTheIdentity) {
    const Matrix3 identity{{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}}};
    EXPECT_EQ(white_balance_matrix({kWorkingWhite}, cie_1931_2deg()), identity);
}

// pbrt-v4's 6500, which is D65, whose chromaticity has four digits in the working white: almost nothing changes.
TEST(WhiteBalance, FromD65ChangesAlmostNothing) {
    const double kelvin = daylight_temperature_of_nominal(6500.0);
    const Matrix3 matrix = white_balance_matrix({TemperatureWhite{kelvin}}, cie_1931_2deg());
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(matrix.m[i][j], i == j ? 1.0 : 0.0, 1e-3);
    }
}

// The two kinds of light that a temperature stands for meet with a step; the header says how large.
TEST(WhiteBalance, StepAt4000K) {
    const Chromaticity daylight = daylight_chromaticity(4000.0);
    const Chromaticity blackbody = chromaticity_of(xyz_of_radiance(BlackbodySpectrum{4000.0}));
    EXPECT_NEAR(std::hypot(daylight.x - blackbody.x, daylight.y - blackbody.y), 0.0073, 5e-5);
}

TEST(WhiteBalance, SensorThatIsBlindToTheLightIsRefused) {
    const Observer blind{"blind", 400, {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}};
    EXPECT_THROW(static_cast<void>(white_balance_matrix({TemperatureWhite{3000.0}}, blind)), std::invalid_argument);
}

// Balanced for blue sky, violet light has a negative Y: it is a colour, not a mistake, and must not be dropped.
TEST(WhiteBalance, FilmKeepsNegativeYOfRealLightAndDropsNegativeLight) {
    Film film({1, 1, {.white_balance = WhiteBalance{TemperatureWhite{20000.0}}}});
    FilmTile tile = film.make_tile(film.bounds());
    SampledWavelengths<1> violet;
    violet.lambda_nm = {432.0f};
    violet.pdf = {1.0f};
    const SensorSample seen = film.sensor().sense(violet, SampledSpectrum<1>(1.0f));
    ASSERT_LT(seen.xyz.y, -1.0f);
    EXPECT_NEAR(static_cast<double>(seen.luminance), kLuminousEfficacy * eval(cie_1931_2deg(), 432.0).y, 1e-4);

    tile.add(0, 0, violet, SampledSpectrum<1>(1.0f), 1.0f);
    EXPECT_EQ(tile.dropped().count(), 0u);
    tile.add(0, 0, violet, SampledSpectrum<1>(-1.0f), 1.0f);
    tile.add(0, 0, violet, SampledSpectrum<1>(std::nanf("")), 1.0f);
    EXPECT_EQ(tile.dropped().count(), 2u);
    film.merge(tile);
    EXPECT_EQ(film.sample_count(), 1u);
    EXPECT_EQ(film.xyz_image()(0, 0), seen.xyz);
}

}  // namespace
}  // namespace emulsion
