#include "pathtracer/fresnel.h"

#include <cmath>
#include <complex>

#include <gtest/gtest.h>

namespace emulsion {
namespace {

// The textbook form, on complex numbers: r = (a - b) / (a + b) for both polarisations.
double complex_fresnel(double cos_i, double eta, double k) {
    const std::complex<double> n(eta, k), cos_t = std::sqrt(1.0 - (1.0 - cos_i * cos_i) / (n * n));
    const auto perpendicular = (cos_i - n * cos_t) / (cos_i + n * cos_t);
    const auto parallel = (n * cos_i - cos_t) / (n * cos_i + cos_t);
    return 0.5 * (std::norm(perpendicular) + std::norm(parallel));
}

TEST(Fresnel, DielectricsAtTheirLimits) {
    // At normal incidence ((n - 1) / (n + 1))^2, at grazing incidence 1.
    EXPECT_NEAR(fresnel_dielectric(1.0, 1.5), 0.04, 1e-15);
    EXPECT_NEAR(fresnel_dielectric(1.0, 1.0 / 1.5), 0.04, 1e-15);
    EXPECT_EQ(fresnel_dielectric(0.0, 1.5), 1.0);
    EXPECT_EQ(fresnel_dielectric(0.3, 1.0), 0.0);
    // At Brewster's angle, tan = n, only one polarisation is reflected, by ((n^2 - 1) / (n^2 + 1))^2.
    const double brewster = 1.0 / std::sqrt(1.0 + 1.5 * 1.5), r = (1.5 * 1.5 - 1.0) / (1.5 * 1.5 + 1.0);
    EXPECT_NEAR(fresnel_dielectric(brewster, 1.5), 0.5 * r * r, 1e-15);
    // From inside, total reflection from sin = 1/n on, and continuous there.
    const double critical = std::sqrt(1.0 - 1.0 / (1.5 * 1.5));
    EXPECT_EQ(fresnel_dielectric(critical - 1e-9, 1.0 / 1.5), 1.0);
    EXPECT_NEAR(fresnel_dielectric(critical + 1e-12, 1.0 / 1.5), 1.0, 1e-4);
}

// A ray and the ray that it becomes see the same boundary: R(cos_i, n) = R(cos_t, 1/n).
TEST(Fresnel, DielectricsLookTheSameFromBothSides) {
    for (const double eta : {1.1, 1.33, 1.5, 2.4}) {
        for (double cosine = 0.05; cosine <= 1.0; cosine += 0.05) {
            const double refracted = std::sqrt(refracted_cosine2(cosine, eta));
            EXPECT_NEAR(fresnel_dielectric(cosine, eta), fresnel_dielectric(refracted, 1.0 / eta), 1e-13);
        }
    }
}

TEST(Fresnel, ConductorsAgreeWithComplexNumbers) {
    for (const double eta : {0.05, 0.15, 0.5, 1.0, 1.5, 3.0}) {
        for (const double k : {0.0, 1e-3, 0.5, 2.0, 4.0, 8.0}) {
            if (eta == 1.0 && k == 0.0) continue;  // nothing there
            for (const double cosine : {0.0, 1e-4, 0.1, 0.4, 0.7, 0.95, 1.0}) {
                EXPECT_NEAR(fresnel_conductor(cosine, eta, k), complex_fresnel(cosine, eta, k), 1e-11)
                    << eta << " + " << k << "i at " << cosine;
            }
        }
    }
    EXPECT_EQ(fresnel_conductor(0.5, 1.0, 0.0), 0.0);
}

TEST(Fresnel, FloatAgreesWithDouble) {
    double worst_dielectric = 0.0, worst_conductor = 0.0;
    for (int i = 0; i <= 1000; ++i) {
        const auto cosine = static_cast<float>(i) / 1000.0f;
        for (const float eta : {0.4f, 0.66f, 0.9f, 0.999f, 1.001f, 1.33f, 1.5f, 2.4f}) {
            // Next to the critical angle the curve is a square root: no rounding of the cosine tells where.
            const double c = static_cast<double>(cosine), n = static_cast<double>(eta);
            if (std::abs(refracted_cosine2(c, n)) < 1e-3) continue;
            worst_dielectric =
                std::max(worst_dielectric,
                         std::abs(static_cast<double>(fresnel_dielectric(cosine, eta)) - fresnel_dielectric(c, n)));
            for (const float k : {0.0f, 0.1f, 2.0f, 8.0f}) {
                worst_conductor =
                    std::max(worst_conductor, std::abs(static_cast<double>(fresnel_conductor(cosine, eta, k)) -
                                                       fresnel_conductor(c, n, static_cast<double>(k))));
            }
        }
    }
    EXPECT_LT(worst_dielectric, 1e-5);
    EXPECT_LT(worst_conductor, 1e-5);
}

}  // namespace
}  // namespace emulsion
