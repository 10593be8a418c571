#include "spectrum/wavelength_pdf.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "spectrum/data_table.h"
#include "spectrum/wavelength_table.h"

namespace emulsion {
namespace {

struct FollowsFl11 : TabulatedWavelengthPdf {
    FollowsFl11() : TabulatedWavelengthPdf(wavelength_importance(tabulated_spectrum("illuminants_5nm", "FL11"))) {}
};

// What holds for every density.
template <class Pdf>
class WavelengthPdf : public testing::Test {
  protected:
    Pdf distribution_;

    // Integral of the density from 360 nm, by Simpson's rule on the quarters of each nanometre, from inside: a table is
    // constant there.
    [[nodiscard]] double numeric_cdf(double lambda_nm) const {
        double sum = 0.0;
        for (double start_nm = kMinWavelength_nm; start_nm < lambda_nm; start_nm += 0.25) {
            const double a = start_nm + 1e-12, b = std::min(start_nm + 0.25, lambda_nm) - 1e-12;
            sum +=
                (b - a) / 6.0 * (distribution_.pdf(a) + 4.0 * distribution_.pdf(0.5 * (a + b)) + distribution_.pdf(b));
        }
        return sum;
    }
};

using Densities = testing::Types<UniformWavelengthPdf, VisibleWavelengthPdf, FollowsFl11>;
TYPED_TEST_SUITE(WavelengthPdf, Densities);

// 1e-9: the 2e-12 nm left out of each quarter nanometre.
TYPED_TEST(WavelengthPdf, IntegratesToOne) { EXPECT_NEAR(this->numeric_cdf(kMaxWavelength_nm), 1.0, 1e-9); }

TYPED_TEST(WavelengthPdf, IsZeroOutsideAndPositiveInside) {
    const TypeParam distribution;
    for (const double lambda_nm : {-1.0, 0.0, 359.99, 830.01, 1e9, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_EQ(distribution.pdf(lambda_nm), 0.0) << lambda_nm;
    }
    for (const double lambda_nm : {360.0, 360.5, 538.0, 829.999, 830.0}) EXPECT_GT(distribution.pdf(lambda_nm), 0.0);
}

TYPED_TEST(WavelengthPdf, SamplesInvertTheDistribution) {
    const TypeParam distribution;
    for (int i = 0; i < 64; ++i) {
        const double u = i / 64.0;
        const ExactWavelengthSample sample = distribution.exact(u);
        EXPECT_NEAR(this->numeric_cdf(sample.lambda_nm), u, 1e-9) << u;
        // Not at the whole nanometres, where a table jumps.
        if (i == 0) continue;
        EXPECT_NEAR(sample.pdf, distribution.pdf(sample.lambda_nm), 1e-12) << u;
    }
    EXPECT_NEAR(distribution.exact(0.0).lambda_nm, 360.0, 1e-9);
    EXPECT_NEAR(distribution.exact(std::nextafter(1.0, 0.0)).lambda_nm, 830.0, 1e-9);
}

TYPED_TEST(WavelengthPdf, FastSampleFollowsItsTwin) {
    const TypeParam distribution;
    constexpr int kCount = 1 << 16;
    for (int i = 0; i <= kCount; ++i) {
        // The ends too.
        const double u = i == kCount ? std::nextafter(1.0, 0.0) : static_cast<double>(i) / kCount;
        const WavelengthSample sample = distribution.sample(u);
        const ExactWavelengthSample exact = distribution.exact(u);
        ASSERT_NEAR(static_cast<double>(sample.lambda_nm), exact.lambda_nm, 1e-4) << u;
        ASSERT_NEAR(static_cast<double>(sample.pdf), exact.pdf, 1e-6 * exact.pdf) << u;
    }
}

TEST(VisibleWavelengthPdf, PeaksInTheGreen) {
    const VisibleWavelengthPdf distribution;
    EXPECT_GT(distribution.pdf(538.0), 2.0 * distribution.pdf(400.0));
}

TEST(VisibleWavelengthPdf, OneFormServesBothSides) {
    const VisibleWavelengthPdf distribution;
    // Not the ends, where rounding can leave the range.
    for (int i = 1; i < 64; ++i) {
        const double u = i / 64.0;
        EXPECT_EQ(distribution.exact(u).lambda_nm, distribution.sample_nm(u));
        const double pdf = distribution.pdf(distribution.sample_nm(u));
        EXPECT_NEAR(distribution.exact(u).pdf, pdf, 1e-12 * pdf) << u;
    }
}

// Nothing is missed: what the light of the table lacks keeps its even share.
TEST(TabulatedWavelengthPdf, KeepsTheUniformShare) {
    WavelengthImportance green;
    green.per_nm[180] = 1.0;  // 540-541 nm
    const TabulatedWavelengthPdf distribution(green, 0.25f);
    EXPECT_NEAR(distribution.pdf(700.5), 0.25 / 470.0, 1e-13);
    EXPECT_NEAR(distribution.pdf(540.5), 0.75 + 0.25 / 470.0, 1e-13);
}

// At a share of 1 the light doesn't matter.
TEST(TabulatedWavelengthPdf, IsUniformAtShareOne) {
    const TabulatedWavelengthPdf distribution(wavelength_importance(tabulated_spectrum("illuminants_5nm", "FL11")),
                                              1.0f);
    for (const double u : {0.0, 0.3, 0.99}) {
        EXPECT_NEAR(distribution.exact(u).lambda_nm, 360.0 + 470.0 * u, 1e-9);
        EXPECT_NEAR(distribution.exact(u).pdf, 1.0 / 470.0, 1e-15);
    }
}

}  // namespace
}  // namespace emulsion
