#include "spectrum/observer.h"

#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "spectrum/catalogue.h"
#include "spectrum/chromaticity.h"
#include "spectrum/colorimetry.h"
#include "spectrum/data_table.h"
#include "spectrum/luminous_efficiency.h"

namespace emulsion {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

XYZd sum_of(const Observer& observer) {
    XYZd sum;
    for (const XYZd& value : observer.value) sum = sum + value;
    return sum;
}

TEST(Observers, AreKnownByNameYearAndField) {
    EXPECT_THAT(observer_names(), ElementsAre("cie_1931_2deg", "cie_1964_10deg", "cie_2015_2deg"));
    for (const char* name : {"cie_1931_2deg", "CIE_1931_2DEG", "1931", "1931 2deg", "CIE 1931", "CIE 1931 2 degrees"}) {
        EXPECT_EQ(&observer(name), &cie_1931_2deg()) << name;
    }
    for (const char* name : {"Cie-1964-10deg", "1964", "1964_10deg", "cie 1964"}) {
        EXPECT_EQ(&observer(name), &cie_1964_10deg()) << name;
    }
    for (const char* name : {"cie_2015_2deg", "2015"}) EXPECT_EQ(&observer(name), &cie_2015_2deg()) << name;
    for (const std::string_view name : observer_names()) EXPECT_EQ(&observer(observer(name).name), &observer(name));
}

TEST(Observers, AnUnknownNameListsTheKnownOnesNearestFirst) {
    EXPECT_THAT([] { (void)observer("cie_1965_10deg"); },
                ThrowsMessage<std::invalid_argument>(
                    AllOf(HasSubstr("observer \"cie_1965_10deg\""), HasSubstr("expected cie_1964_10deg, cie_"))));
    EXPECT_THROW((void)observer(""), std::invalid_argument);
}

TEST(Observers, CoverTheRangesOfTheirTables) {
    EXPECT_EQ(cie_1931_2deg().first_nm, 360);
    EXPECT_EQ(cie_1931_2deg().last_nm(), 830);
    EXPECT_EQ(cie_1964_10deg().first_nm, 360);
    EXPECT_EQ(cie_1964_10deg().last_nm(), 830);
    EXPECT_EQ(cie_2015_2deg().first_nm, 390);
    EXPECT_EQ(cie_2015_2deg().last_nm(), 830);
    EXPECT_EQ(eval(cie_2015_2deg(), 389.999), XYZd{});
    EXPECT_GT(eval(cie_2015_2deg(), 390.0).z, 0.0);
}

// CIE 15:2004, table T.5.
TEST(Observers, Of1964HasThePublishedValues) {
    EXPECT_EQ(eval(cie_1964_10deg(), 550.0), (XYZd{0.529826, 0.991761, 0.003988}));
    EXPECT_EQ(eval(cie_1964_10deg(), 600.0), (XYZd{1.123990, 0.658341, 0.0}));
}

// CIE 170-2:2015 scales xbar and zbar to the area under ybar; they are equal to the seven digits of the tables.
TEST(Observers, Of2015HasEqualAreas) {
    const XYZd sum = sum_of(cie_2015_2deg());
    EXPECT_NEAR(sum.x / sum.y, 1.0, 5e-8);
    EXPECT_NEAR(sum.z / sum.y, 1.0, 5e-8);
}

// Chromaticities for 10 degrees: CIE 15:2004, table T.3. The published ones are sums at 5 nm over 380-780 nm; twice the
// rounding of the fifth decimal is left for the digits of the tables.
TEST(Observers, Of1964HasThePublishedWhitePoints) {
    struct Case {
        const char* name;
        double x, y;
    };
    for (const Case& c : {Case{"A", 0.45117, 0.40594}, Case{"C", 0.31039, 0.31905}, Case{"D50", 0.34773, 0.35952},
                          Case{"D65", 0.31381, 0.33098}, Case{"D75", 0.29968, 0.31740}}) {
        const PiecewiseLinearSpectrum illuminant = tabulated_spectrum("illuminants_5nm", c.name);
        XYZd sum;
        for (std::size_t i = 0; i < illuminant.value.size(); ++i) {
            sum = sum + illuminant.value[i] * eval(cie_1964_10deg(), illuminant.lambda_nm[i]);
        }
        const Chromaticity white = chromaticity_of(sum);
        EXPECT_NEAR(white.x, c.x, 1e-5) << c.name;
        EXPECT_NEAR(white.y, c.y, 1e-5) << c.name;
    }
}

// Colorimetry integrates over the range of whichever observer it is given: a jump of a spectrum or of the observer at
// the ends must not leak, and the perfect reflector is white for all of them.
TEST(Observers, WorkWithColorimetryOverTheirOwnRange) {
    for (const std::string_view name : observer_names()) {
        const Observer& who = observer(name);
        const XYZd flat = xyz_of_radiance(ConstantSpectrum{1.0 / 683.0}, who), sum = sum_of(who);
        EXPECT_NEAR(flat.x, sum.x - 0.5 * (who.value.front().x + who.value.back().x), 1e-10) << name;
        EXPECT_NEAR(flat.y, sum.y - 0.5 * (who.value.front().y + who.value.back().y), 1e-10) << name;
        EXPECT_NEAR(flat.z, sum.z - 0.5 * (who.value.front().z + who.value.back().z), 1e-10) << name;
        EXPECT_NEAR(xyz_of_reflectance(ConstantSpectrum{1.0}, catalogue_spectrum("FL11"), who).y, 1.0, 1e-14) << name;
    }
    const PiecewiseLinearSpectrum violet{{370.0, 389.0}, {1.0, 1.0}};
    EXPECT_GT(xyz_of_radiance(violet, cie_1931_2deg()).y, 0.0);
    EXPECT_EQ(xyz_of_radiance(violet, cie_2015_2deg()), XYZd{});
}

TEST(LuminousEfficiency, PhotopicIsYbar) {
    for (const double lambda_nm : photopic_efficiency().lambda_nm) {
        EXPECT_NEAR(eval(photopic_efficiency(), lambda_nm), eval(cie_1931_2deg(), lambda_nm).y, 1e-12) << lambda_nm;
    }
    EXPECT_EQ(eval(photopic_efficiency(), 555.0), 1.0);
    EXPECT_EQ(eval(photopic_efficiency(), 359.0), 0.0);
}

// The two scales meet at 555 nm: 1700 lm/W is 683 / V'(555 nm), with V' to its three published digits.
TEST(LuminousEfficiency, ScotopicPeaksAt507AndMeetsPhotopicAt555) {
    const PiecewiseLinearSpectrum& scotopic = scotopic_efficiency();
    for (const double lambda_nm : scotopic.lambda_nm) {
        // To the digits of the table the peak spreads over its two neighbours.
        const bool is_peak = std::abs(lambda_nm - 507.0) <= 1.0;
        EXPECT_EQ(eval(scotopic, lambda_nm) == 1.0, is_peak) << lambda_nm;
        EXPECT_LE(eval(scotopic, lambda_nm), 1.0);
    }
    EXPECT_NEAR(1700.0 * eval(scotopic, 555.0), 683.0, 1700.0 * 0.0005);
    EXPECT_EQ(eval(scotopic, 781.0), 0.0);
}

}  // namespace
}  // namespace emulsion
