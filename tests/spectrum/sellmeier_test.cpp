#include "spectrum/sellmeier.h"

#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace emulsion {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

// Lines of helium (d) and hydrogen (F, C), nm.
constexpr double kD_nm = 587.5618, kF_nm = 486.1327, kC_nm = 656.2725;

// The catalogue's columns nd and Vd, to the five and two decimals that they are printed with.
TEST(SellmeierGlass, HasTheCataloguesIndexAndAbbeNumber) {
    ASSERT_EQ(sellmeier_glasses().size(), 14u);
    for (const SellmeierGlass& glass : sellmeier_glasses()) {
        const double nd = index_of_refraction(glass, kD_nm);
        const double dispersion = index_of_refraction(glass, kF_nm) - index_of_refraction(glass, kC_nm);
        EXPECT_NEAR(nd, glass.nd, 5e-6) << glass.name;
        EXPECT_NEAR((nd - 1.0) / dispersion, glass.vd, 5e-3) << glass.name;
    }
}

// N-BK7 at the lines of its data sheet other than d, F and C: n at 1014.0 nm (t), 435.8343 nm (g), 365.0146 nm (i).
TEST(SellmeierGlass, HasTheDataSheetsIndices) {
    const SellmeierGlass& glass = sellmeier_glass("N-BK7");
    EXPECT_NEAR(index_of_refraction(glass, 1013.98), 1.50731, 5e-6);
    EXPECT_NEAR(index_of_refraction(glass, 435.8343), 1.52668, 5e-6);
    EXPECT_NEAR(index_of_refraction(glass, 365.0146), 1.53627, 5e-6);
}

TEST(SellmeierGlass, IsKnownByNameInAnyCase) {
    EXPECT_EQ(sellmeier_glass("n_bk7"), sellmeier_glass("N_BK7"));
    EXPECT_EQ(sellmeier_glass("Fused Silica").name, "fused_silica");
    EXPECT_THAT([] { (void)sellmeier_glass("N_BK8"); },
                ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("glass \"N_BK8\""), HasSubstr("expected N_BK7"))));
}

TEST(SellmeierGlass, RefusesWavelengthsOutsideTheCataloguesRange) {
    const SellmeierGlass& glass = sellmeier_glass("SF11");
    EXPECT_NO_THROW((void)index_of_refraction(glass, 390.0));
    EXPECT_NO_THROW((void)index_of_refraction(glass, 2500.0));
    EXPECT_THAT([&] { (void)index_of_refraction(glass, 389.9); },
                ThrowsMessage<std::invalid_argument>(
                    AllOf(HasSubstr("389.9"), HasSubstr("SF11"), HasSubstr("from 390 to 2500 nm"))));
    EXPECT_THROW((void)index_of_refraction(glass, 2500.1), std::invalid_argument);
    EXPECT_THROW((void)index_of_refraction(glass, NAN), std::invalid_argument);
    EXPECT_EQ(extrapolated_index(glass, 390.0), index_of_refraction(glass, 390.0));
    EXPECT_GT(extrapolated_index(glass, 360.0), extrapolated_index(glass, 390.0));
}

}  // namespace
}  // namespace emulsion
