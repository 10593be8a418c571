#include "spectrum/spectral_locus.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"
#include "spectrum/data_table.h"

namespace emulsion {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;
using Line = SpectralLocus::Crossing::Line;

constexpr Chromaticity kEqualEnergy = {1.0 / 3.0, 1.0 / 3.0};

Observer observer_of(const std::string& table_name) {
    const DataTable& table = data_table(table_name);
    Observer observer{table_name, static_cast<int>(table.columns[0][0]), {}};
    for (std::size_t i = 0; i < table.row_count(); ++i) {
        observer.value.push_back({table.columns[1][i], table.columns[2][i], table.columns[3][i]});
    }
    return observer;
}

TEST(SpectralLocus, EndsWhereTheHueStopsMoving) {
    struct Case {
        const char* table;
        int violet_nm, red_nm;
    };
    // CIE 15:2004 gives x = 0.73469 for all of 699-830 nm. The two others turn back: largest x of their tables.
    for (const Case& c : {Case{"cie_1931_2deg_xyz_1nm", 360, 699}, Case{"cie_1964_10deg_xyz_1nm", 360, 701},
                          Case{"cie_2015_2deg_xyz_1nm", 390, 703}}) {
        const SpectralLocus locus(observer_of(c.table));
        EXPECT_EQ(locus.violet_nm(), c.violet_nm) << c.table;
        EXPECT_EQ(locus.red_nm(), c.red_nm) << c.table;
    }
}

TEST(SpectralLocus, HoldsMonochromaticLightOnItsBorder) {
    struct Case {
        const char* table;
        double concave;  // as documented
    };
    for (const Case& c : {Case{"cie_1931_2deg_xyz_1nm", 1.5e-4}, Case{"cie_1964_10deg_xyz_1nm", 2.2e-5},
                          Case{"cie_2015_2deg_xyz_1nm", 8.3e-4}}) {
        const Observer observer = observer_of(c.table);
        const SpectralLocus locus(observer);
        double deepest = 0.0;
        for (double lambda_nm = locus.violet_nm(); lambda_nm <= locus.red_nm(); lambda_nm += 0.25) {
            const double distance = locus.signed_distance(chromaticity_of(eval(observer, lambda_nm)));
            EXPECT_GE(distance, -1e-15) << c.table << " " << lambda_nm;
            deepest = std::max(deepest, distance);
        }
        EXPECT_LE(deepest, c.concave) << c.table;
        EXPECT_GE(deepest, 0.9 * c.concave) << c.table << ": the documented bound is too wide";
    }
}

TEST(SpectralLocus, HoldsEveryMixtureOfLights) {
    const Observer& observer = cie_1931_2deg();
    const SpectralLocus& locus = cie_1931_spectral_locus();
    Pcg32 random(7);
    for (int i = 0; i < 2000; ++i) {
        XYZd sum;
        const int lights = 1 + i % 4;
        for (int j = 0; j < lights; ++j) {
            const double power = random.next_float();
            sum = sum + power * eval(observer, 360.0 + 470.0 * random.next_float());
        }
        EXPECT_GE(locus.signed_distance(chromaticity_of(sum)), -1e-15);
    }
}

TEST(SpectralLocus, KnowsImaginaryColours) {
    const SpectralLocus& locus = cie_1931_spectral_locus();
    EXPECT_GT(locus.signed_distance(kEqualEnergy), 0.1);
    // Green and blue of ACES AP0 (SMPTE ST 2065-1) lie far outside. Above 650 nm the border is the line x + y = 1.
    EXPECT_LT(locus.signed_distance({0.0, 1.0}), -0.1);
    EXPECT_LT(locus.signed_distance({0.0001, -0.077}), -0.05);
    EXPECT_NEAR(locus.signed_distance({0.73, 0.27}), 0.0, 1e-15);
    EXPECT_NEAR(locus.signed_distance({0.73 + 0.001, 0.27 + 0.001}), -0.001 * std::sqrt(2.0), 1e-15);
    // Below the purple line, which runs from 360 nm to the far red.
    const Chromaticity violet = chromaticity_of(cie_1931_2deg().value.front());
    EXPECT_LT(locus.signed_distance({0.5 * (violet.x + 0.73469), 0.5 * (violet.y + 0.26531) - 0.01}), -0.008);
    EXPECT_TRUE(std::isnan(locus.signed_distance(chromaticity_of(XYZd{}))));
}

TEST(SpectralLocus, RaysCrossWhereThePolygonIs) {
    const SpectralLocus& locus = cie_1931_spectral_locus();
    // Half-way between two whole nm in amount of light, not in distance.
    const XYZd a = eval(cie_1931_2deg(), 520.0), b = eval(cie_1931_2deg(), 521.0);
    const SpectralLocus::Crossing crossing = locus.crossing(kEqualEnergy, chromaticity_of(a + b));
    EXPECT_EQ(crossing.line, Line::spectral);
    EXPECT_NEAR(crossing.lambda_nm, 520.5, 1e-10);
    EXPECT_NEAR(crossing.distance, 1.0, 1e-14);

    const SpectralLocus::Crossing purple = locus.crossing(kEqualEnergy, {0.4, 0.2});
    EXPECT_EQ(purple.line, Line::purple);
    EXPECT_TRUE(std::isnan(purple.lambda_nm));
    // On the line from 360 nm to 699 nm.
    const Chromaticity violet = chromaticity_of(eval(cie_1931_2deg(), 360.0)),
                       red = chromaticity_of(eval(cie_1931_2deg(), 699.0));
    const double t = (purple.point.x - violet.x) / (red.x - violet.x);
    EXPECT_NEAR(purple.point.y, violet.y + t * (red.y - violet.y), 1e-15);
}

// With a notch between 401 and 403 nm: from a white in the horn below 403 nm, a ray leaves, enters and leaves again.
TEST(SpectralLocus, TheLastOfSeveralCrossingsCounts) {
    const auto at = [](double x, double y) { return XYZd{x, y, 1.0 - x - y}; };
    const Observer notched{"notched", 400, {at(0.15, 0.05), at(0.05, 0.4), at(0.2, 0.42), at(0.1, 0.8), at(0.7, 0.28)}};
    const Chromaticity white{0.15, 0.7}, on_first_edge{0.09, 0.26};
    const SpectralLocus::Crossing crossing = SpectralLocus(notched).crossing(white, on_first_edge);
    EXPECT_EQ(crossing.line, Line::spectral);
    EXPECT_NEAR(crossing.lambda_nm, 400.6, 1e-12);
    EXPECT_NEAR(crossing.distance, 1.0, 1e-14);
}

TEST(SpectralLocus, RefusesRaysFromOutside) {
    const SpectralLocus& locus = cie_1931_spectral_locus();
    EXPECT_THAT(
        [&] {
            (void)locus.crossing({0.1, 0.1}, kEqualEnergy);
        },
        ThrowsMessage<std::invalid_argument>(HasSubstr("white (0.1, 0.1)")));
    EXPECT_THROW((void)locus.crossing(kEqualEnergy, kEqualEnergy), std::invalid_argument);
    EXPECT_THROW((void)locus.crossing(kEqualEnergy, chromaticity_of(XYZd{})), std::invalid_argument);
    EXPECT_THROW((void)locus.crossing(chromaticity_of(XYZd{}), kEqualEnergy), std::invalid_argument);
}

TEST(SpectralLocus, RefusesObserversWithoutOne) {
    Observer dark = cie_1931_2deg();
    dark.value[140] = {};
    EXPECT_THAT([&] { (void)SpectralLocus(dark); }, ThrowsMessage<std::invalid_argument>(HasSubstr("at 500 nm")));
    const Observer grey{"grey", 400, {{1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}, {2.0, 2.0, 2.0}}};
    EXPECT_THAT([&] { (void)SpectralLocus(grey); }, ThrowsMessage<std::invalid_argument>(HasSubstr("observer grey")));
}

}  // namespace
}  // namespace emulsion
