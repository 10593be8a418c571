#include "tonemap/contrast.h"

#include <cmath>

#include <gtest/gtest.h>

#include "prepared_operator.h"
#include "test_pictures.h"

namespace emulsion {
namespace {

// By hand: 1.219^2.5 = 1.640625, 2.219^2.5 = 7.334884; 100^0.4 = 6.309573.
TEST(JustNoticeableDifference, HasThePapersValues) {
    EXPECT_NEAR(just_noticeable_difference_cdm2(0.0), 0.0594 * 1.640625, 1e-7);
    EXPECT_NEAR(just_noticeable_difference_cdm2(1.0), 0.0594 * 7.334884, 1e-6);
    EXPECT_NEAR(just_noticeable_difference_cdm2(100.0), 0.0594 * std::pow(1.219 + 6.30957344, 2.5), 1e-6);
}

// s = ((1.219 + 50^0.4) / 1.219)^2.5 in darkness.
TEST(ContrastScale, FactorTendsTo53Point77InDarkness) {
    const Image<XYZ> scene = row_of_greys({1.0f, 2.0f});
    EXPECT_NEAR(100.0 * PreparedOperator(ContrastScale{100.0f}, scene, 1e-30).scale(1.0), 53.77, 0.005);
    EXPECT_NEAR(100.0 * PreparedOperator(ContrastScale{100.0f}, scene, 1e-12).scale(1.0), 53.77, 0.01);
}

TEST(ContrastScale, AdaptedToTheDisplayItIsOne) {
    const PreparedOperator displayed(ContrastScale{80.0f}, row_of_greys({1.0f, 2.0f}), 40.0);
    EXPECT_NEAR(displayed(40.0), 0.5, 1e-14);
    EXPECT_NEAR(displayed(160.0), 2.0, 1e-14);
}

TEST(ContrastScale, FactorIsThatOfThePaper) {
    const double yda = std::pow(50.0, 0.4), ya = std::pow(1000.0, 0.4);
    const double factor = std::pow((1.219 + yda) / (1.219 + ya), 2.5);
    EXPECT_NEAR(PreparedOperator(ContrastScale{}, row_of_greys({1.0f, 2.0f}), 1000.0)(7.0), factor * 0.07, 1e-14);
}

}  // namespace
}  // namespace emulsion
