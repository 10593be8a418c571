#include "spectrum/color_rendering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "spectrum/data_table.h"

namespace emulsion {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr ColorRenderingMethod kEvery5nm = {.integration = ColorRenderingMethod::Integration::every_5nm};

Spectrum lamp(const std::string& name) { return tabulated_spectrum("illuminants_5nm", name); }

TEST(ColorRendering, OfABlackbodyIsPerfect) {
    for (const double t : {1000.0, 2856.0, 4999.0}) {
        const ColorRendering result = color_rendering(BlackbodySpectrum{t}, kEvery5nm);
        // Sums end at 780 nm, and so miss a little of the temperature: most of it, 0.011, at 1000 K.
        EXPECT_NEAR(result.general_index, 100.0, t < 2000.0 ? 0.012 : 0.005) << t;
    }
    const ColorRendering exact = color_rendering(BlackbodySpectrum{2856.0});
    EXPECT_NEAR(exact.reference_K, 2856.0, 1e-6);
    EXPECT_NEAR(exact.reference_distance, 0.0, 1e-10);
    for (const double index : exact.special_index) EXPECT_NEAR(index, 100.0, 1e-6);
}

TEST(ColorRendering, OfDaylightIsPerfectButForRounding) {
    // The tables of D50 to D75 are made with rounded weights of the components (CIE 15:2004, section 3.1), and their
    // colour temperature is found on a locus that is itself a fit: 0.01 in Ra.
    for (const char* name : {"D50", "D55", "D65", "D75"}) {
        const Spectrum light = tabulated_spectrum("illuminants_a_d_300_830_5nm", name);
        EXPECT_NEAR(color_rendering(light, kEvery5nm).general_index, 100.0, 0.01) << name;
        EXPECT_LE(color_rendering(light, kEvery5nm).reference_distance, 1.1e-3) << name;
    }
    EXPECT_NEAR(color_rendering(tabulated_spectrum("illuminants_a_d_300_830_5nm", "D65")).general_index, 99.998, 5e-4);
}

TEST(ColorRendering, OfFluorescentLampsIsThePublishedOne) {
    // CIE 15:2004, table T.7. FL8 comes out at 95.50, where either integer will do.
    constexpr std::array<double, 12> kPublished = {76, 64, 57, 51, 72, 59, 90, 95, 90, 81, 83, 83};
    for (std::size_t i = 0; i < kPublished.size(); ++i) {
        const std::string name = "FL" + std::to_string(i + 1);
        EXPECT_NEAR(color_rendering(lamp(name), kEvery5nm).general_index, kPublished[i], 0.51) << name;
    }
    // Lines between the rows instead of sums: 0.2 at most.
    for (const char* name : {"FL4", "FL11"}) {
        EXPECT_NEAR(color_rendering(lamp(name)).general_index, color_rendering(lamp(name), kEvery5nm).general_index,
                    0.2)
            << name;
    }
}

TEST(ColorRendering, HasThePublishedSpecialIndices) {
    // CIE 15:2004, table T.8: Ra, then R1 to R14. They come out as published only if the reference is daylight from
    // 4000 K up, not from 5000 K as CIE 13.3 has it: otherwise R9 of FL3.8 is 13.6.
    constexpr std::array<std::array<int, 15>, 15> kPublished = {{
        {51, 42, 69, 89, 39, 41, 52, 66, 13, -109, 29, 19, 21, 47, 93},
        {70, 65, 80, 89, 66, 66, 71, 79, 48, -37, 51, 56, 59, 68, 94},
        {72, 64, 80, 89, 69, 69, 74, 81, 49, -63, 52, 62, 68, 68, 93},
        {87, 91, 89, 79, 88, 88, 82, 88, 89, 76, 69, 88, 63, 91, 87},
        {95, 97, 97, 92, 94, 97, 95, 94, 94, 88, 90, 95, 90, 97, 95},
        {96, 97, 97, 93, 97, 97, 95, 96, 96, 93, 90, 97, 92, 98, 95},
        {82, 97, 94, 54, 88, 86, 81, 87, 64, -9, 51, 76, 50, 98, 69},
        {79, 94, 89, 50, 85, 83, 73, 86, 72, 5, 40, 68, 48, 95, 67},
        {79, 94, 89, 48, 84, 84, 72, 85, 78, 22, 38, 68, 51, 95, 66},
        {88, 99, 97, 63, 92, 92, 85, 92, 86, 46, 62, 78, 72, 97, 75},
        {78, 90, 86, 49, 82, 81, 70, 85, 79, 24, 34, 64, 50, 90, 67},
        {93, 95, 98, 92, 95, 94, 97, 93, 83, 58, 88, 93, 85, 97, 94},
        {96, 98, 97, 98, 97, 99, 97, 94, 88, 71, 99, 94, 89, 99, 98},
        {95, 93, 94, 97, 94, 94, 93, 97, 97, 93, 91, 95, 85, 92, 97},
        {98, 99, 99, 96, 98, 99, 100, 98, 98, 96, 99, 100, 95, 98, 98},
    }};
    ColorRenderingMethod method = kEvery5nm;
    method.daylight_from_K = 4000.0;
    for (std::size_t i = 0; i < kPublished.size(); ++i) {
        const std::string name = "FL3_" + std::to_string(i + 1);
        const ColorRendering result = color_rendering(lamp(name), method);
        EXPECT_NEAR(result.general_index, kPublished[i][0], 0.6) << name;
        for (std::size_t j = 1; j <= kTestColorCount; ++j) {
            // R9 falls by 4.6 for every unit of U*, which the strong red has most of: 1.1 is a quarter of a unit.
            EXPECT_NEAR(result.special_index[j - 1], kPublished[i][j], j == 9 ? 1.1 : 0.8) << name << " R" << j;
        }
    }
    EXPECT_NEAR(color_rendering(lamp("FL3_8"), kEvery5nm).special_index[8], 13.6, 0.05) << "daylight from 5000 K";
}

TEST(ColorRendering, GeneralIndexIsTheMeanOfTheFirstEight) {
    const ColorRendering result = color_rendering(lamp("FL11"), kEvery5nm);
    double sum = 0.0;
    for (std::size_t i = 0; i < 8; ++i) sum += result.special_index[i];
    EXPECT_NEAR(result.general_index, sum / 8.0, 1e-12);
    EXPECT_LT(result.special_index[8], result.general_index) << "triphosphor lamps are poor in deep red";
}

TEST(ColorRendering, DoesntDependOnTheScaleOfTheLight) {
    PiecewiseLinearSpectrum bright = tabulated_spectrum("illuminants_5nm", "FL2");
    for (double& value : bright.value) value *= 1e-6;
    EXPECT_NEAR(color_rendering(bright, kEvery5nm).general_index, color_rendering(lamp("FL2"), kEvery5nm).general_index,
                1e-9);
}

TEST(ColorRendering, SaysWhereItMeansLittle) {
    // A sodium lamp is white enough; a green light isn't, and its distance says so.
    EXPECT_LT(color_rendering(lamp("HP1"), kEvery5nm).reference_distance, kLargestReferenceDistance);
    const PiecewiseLinearSpectrum green{{480.0, 540.0, 600.0}, {0.0, 1.0, 0.0}};
    EXPECT_GT(color_rendering(green, kEvery5nm).reference_distance, kLargestReferenceDistance);
}

TEST(ColorRendering, RefusesWhatHasNoReference) {
    EXPECT_THAT([] { (void)color_rendering(ConstantSpectrum{0.0}); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("luminance")));
    EXPECT_THROW((void)color_rendering(ConstantSpectrum{0.0}, kEvery5nm), std::invalid_argument);
    EXPECT_THAT([] { (void)color_rendering(BlackbodySpectrum{30000.0}, kEvery5nm); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("at most 25000 K")));
    const PiecewiseLinearSpectrum blue{{400.0, 450.0, 470.0}, {0.0, 1.0, 0.0}};
    EXPECT_THAT([&] { (void)color_rendering(blue, kEvery5nm); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("no correlated colour temperature")));
    // A lamp of mercury and phosphor: an integral sees its line, sums at 5 nm can't.
    const Spectrum lamp_with_line = sum_of(lamp("FL2"), LineSpectrum{{{546.074, 100.0}}, {}});
    EXPECT_LT(color_rendering(lamp_with_line).general_index, color_rendering(lamp("FL2")).general_index);
    EXPECT_THAT([&] { (void)color_rendering(lamp_with_line, kEvery5nm); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("lines without width")));
    EXPECT_THAT([] { (void)color_rendering(ConstantSpectrum{1.0}, {.daylight_from_K = 3000.0}); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("daylight_from_K = 3000")));
}

}  // namespace
}  // namespace emulsion
