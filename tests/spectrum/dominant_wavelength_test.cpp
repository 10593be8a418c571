#include "spectrum/dominant_wavelength.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "spectrum/colorimetry.h"
#include "spectrum/data_table.h"
#include "spectrum/rgb_space.h"

namespace emulsion {
namespace {

using Kind = DominantWavelength::Kind;

constexpr Chromaticity kD65 = {0.3127, 0.3290};
constexpr std::array<Chromaticity, 3> kWhites = {{kD65, {1.0 / 3.0, 1.0 / 3.0}, {0.44758, 0.40745}}};

Chromaticity monochromatic(double lambda_nm) { return chromaticity_of(eval(cie_1931_2deg(), lambda_nm)); }

Chromaticity mixture(const Chromaticity& a, const Chromaticity& b, double t) {
    return {(1.0 - t) * a.x + t * b.x, (1.0 - t) * a.y + t * b.y};
}

TEST(DominantWavelength, OfMonochromaticLightIsItsOwn) {
    for (const Chromaticity& white : kWhites) {
        for (double lambda_nm = 360.0; lambda_nm <= 699.0; lambda_nm += 0.375) {
            const DominantWavelength result = dominant_wavelength(monochromatic(lambda_nm), white);
            ASSERT_EQ(result.kind, Kind::dominant) << lambda_nm;
            EXPECT_NEAR(result.lambda_nm, lambda_nm, 1e-9);
            EXPECT_NEAR(result.excitation_purity, 1.0, 1e-13) << lambda_nm;
        }
    }
}

TEST(DominantWavelength, OfTheFarRedIsTheEndOfTheLocus) {
    // From 699 nm on, x and y only change in the tables' last digits: documented.
    for (double lambda_nm = 699.0; lambda_nm <= 830.0; lambda_nm += 0.5) {
        const DominantWavelength result = dominant_wavelength(monochromatic(lambda_nm), kD65);
        if (result.kind == Kind::dominant) {
            EXPECT_GT(result.lambda_nm, 698.9) << lambda_nm;
        }
        EXPECT_NEAR(result.excitation_purity, 1.0, 1e-6) << lambda_nm;
    }
}

TEST(DominantWavelength, StaysWhileWhiteIsMixedIn) {
    for (const Chromaticity& white : kWhites) {
        for (const double purity : {1e-9, 0.01, 0.5, 0.99, 1.5}) {
            const DominantWavelength result = dominant_wavelength(mixture(white, monochromatic(520.5), purity), white);
            EXPECT_EQ(result.kind, Kind::dominant);
            // A difference of 1e-9 between two numbers near 0.3 has a relative error of some 1e-7.
            EXPECT_NEAR(result.lambda_nm, 520.5, purity < 1e-6 ? 1e-4 : 1e-9);
            EXPECT_NEAR(result.excitation_purity, purity, 1e-14);
            EXPECT_NEAR(result.border.x, monochromatic(520.5).x, 1e-6);
        }
    }
}

TEST(DominantWavelength, OfPurplesIsComplementary) {
    const Chromaticity violet = monochromatic(360.0), red = monochromatic(699.0);
    for (const double t : {0.01, 0.3, 0.7, 0.99}) {
        const Chromaticity purple = mixture(violet, red, t);
        const DominantWavelength border = dominant_wavelength(purple, kD65);
        ASSERT_EQ(border.kind, Kind::complementary);
        EXPECT_NEAR(border.excitation_purity, 1.0, 1e-13);
        const DominantWavelength half = dominant_wavelength(mixture(kD65, purple, 0.5), kD65);
        ASSERT_EQ(half.kind, Kind::complementary);
        EXPECT_NEAR(half.excitation_purity, 0.5, 1e-13);
        EXPECT_NEAR(half.lambda_nm, border.lambda_nm, 1e-9);
        // White, purple and the complementary light lie on one line, the white between.
        const Chromaticity opposite = monochromatic(half.lambda_nm);
        const double cross = (opposite.x - kD65.x) * (purple.y - kD65.y) - (opposite.y - kD65.y) * (purple.x - kD65.x);
        EXPECT_NEAR(cross, 0.0, 1e-14);
        EXPECT_LT((opposite.x - kD65.x) * (purple.x - kD65.x) + (opposite.y - kD65.y) * (purple.y - kD65.y), 0.0);
    }
    // The magenta of sRGB is the complement of its green.
    const RgbSpace& srgb = rgb_space("sRGB");
    const auto xyz = xyz_from_rgb(srgb) * std::array<double, 3>{1.0, 0.0, 1.0};
    const DominantWavelength magenta = dominant_wavelength(chromaticity_of({xyz[0], xyz[1], xyz[2]}), srgb.white);
    EXPECT_EQ(magenta.kind, Kind::complementary);
    EXPECT_NEAR(magenta.lambda_nm, dominant_wavelength(srgb.green, srgb.white).lambda_nm, 1e-9);
}

TEST(DominantWavelength, OfWhiteIsNone) {
    const DominantWavelength result = dominant_wavelength(kD65, kD65);
    EXPECT_EQ(result.kind, Kind::none);
    EXPECT_TRUE(std::isnan(result.lambda_nm));
    EXPECT_EQ(result.excitation_purity, 0.0);
    EXPECT_THROW((void)dominant_wavelength({0.1, 0.1}, {0.1, 0.1}), std::invalid_argument) << "a white outside";
    EXPECT_THROW((void)dominant_wavelength(chromaticity_of(XYZd{}), kD65), std::invalid_argument) << "black";
}

// What programs publish: the locus at every 5 nm, and wavelengths divided as evenly as the distances between.
double dominant_by_chords_of_5nm(const Chromaticity& colour, const Chromaticity& white) {
    for (double lambda_nm = 380.0; lambda_nm < 695.0; lambda_nm += 5.0) {
        const Chromaticity a = monochromatic(lambda_nm), b = monochromatic(lambda_nm + 5.0);
        const auto across = [&](const Chromaticity& p) {
            return (colour.x - white.x) * (p.y - white.y) - (colour.y - white.y) * (p.x - white.x);
        };
        const double t = across(a) / (across(a) - across(b));
        const bool ahead = (a.x - white.x) * (colour.x - white.x) + (a.y - white.y) * (colour.y - white.y) > 0.0;
        if (t >= 0.0 && t < 1.0 && ahead) return lambda_nm + 5.0 * t;
    }
    return 0.0;
}

TEST(DominantWavelength, OfPrimariesIsThePublishedOne) {
    struct Case {
        const char* space;
        std::array<double, 3> published_nm;
    };
    // BT.709 and Display P3 about D65, as colour calculators give them (B. Lindbloom's: 611.4 nm for sRGB red). They go
    // by a locus at every 5 nm, which moves red by 0.09 nm and blue by 0.11 nm; done likewise, all agree.
    for (const Case& c : {Case{"Rec709", {611.4, 549.1, 464.2}}, Case{"Display_P3", {614.9, 544.2, 464.2}}}) {
        const RgbSpace& space = rgb_space(c.space);
        const std::array<Chromaticity, 3> primary = {space.red, space.green, space.blue};
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(dominant_by_chords_of_5nm(primary[i], space.white), c.published_nm[i], 0.05) << c.space << i;
            EXPECT_NEAR(dominant_wavelength(primary[i], space.white).lambda_nm, c.published_nm[i], 0.05 + 0.11)
                << c.space << i;
        }
    }
}

TEST(DominantWavelength, OfBt2020IsWhatItsPrimariesWereMadeOf) {
    // Report ITU-R BT.2246: monochromatic lights of 630, 532 and 467 nm, their x and y rounded to three decimals.
    const RgbSpace& space = rgb_space("Rec2020");
    const std::array<Chromaticity, 3> primary = {space.red, space.green, space.blue};
    const std::array<double, 3> made_of_nm = {630.0, 532.0, 467.0};
    for (std::size_t i = 0; i < 3; ++i) {
        const Chromaticity exact = monochromatic(made_of_nm[i]);
        EXPECT_NEAR(primary[i].x, exact.x, 5.01e-4);
        EXPECT_NEAR(primary[i].y, exact.y, 5.01e-4);
        // Half a unit of the third decimal is 0.11 nm along the locus at 467 nm.
        EXPECT_NEAR(dominant_wavelength(primary[i], space.white).lambda_nm, made_of_nm[i], 0.11);
        EXPECT_NEAR(dominant_wavelength(primary[i], space.white).excitation_purity, 1.0, 1e-3);
    }
}

}  // namespace
}  // namespace emulsion
