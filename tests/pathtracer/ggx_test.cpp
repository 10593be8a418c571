#include "pathtracer/ggx.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/random.h"

namespace emulsion {
namespace {

using Vec = Imath::V3d;
constexpr double kPi = std::numbers::pi;

Vec direction(double cosine, double azimuth) {
    const double sine = std::sqrt(1.0 - cosine * cosine);
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

/// Integral of f over the upper hemisphere, weighted so that narrow lobes about the normal are resolved: the tangent of
/// the angle is spread over alpha.
template <class F>
double hemisphere_integral(double alpha, const F& f) {
    constexpr int kTheta = 4000, kPhi = 64;
    double sum = 0.0;
    for (int i = 0; i < kTheta; ++i) {
        // tan = alpha s / (1 - s): dcos = cos^3 tan dtan, dtan = alpha / (1 - s)^2 ds.
        const double s = (i + 0.5) / kTheta, tangent = alpha * s / (1.0 - s);
        const double cosine = 1.0 / std::sqrt(1.0 + tangent * tangent);
        const double measure = cosine * cosine * cosine * tangent * alpha / ((1.0 - s) * (1.0 - s)) / kTheta;
        for (int j = 0; j < kPhi; ++j)
            sum += f(direction(cosine, 2.0 * kPi * (j + 0.5) / kPhi)) * measure * 2 * kPi / kPhi;
    }
    return sum;
}

TEST(Ggx, DensityCoversTheSurfaceOnce) {
    for (const double alpha : {0.01, 0.1, 0.5, 1.0}) {
        const Ggx<double> facets(alpha, alpha);
        EXPECT_NEAR(hemisphere_integral(alpha, [&](const Vec& m) { return facets.density(m) * m.z; }), 1.0, 1e-5);
    }
    const Ggx<double> brushed(0.1, 0.4);
    EXPECT_NEAR(hemisphere_integral(0.2, [&](const Vec& m) { return brushed.density(m) * m.z; }), 1.0, 1e-4);
}

// The visible facets project to just the surface, whatever the direction: Heitz 2014, eq. 14.
TEST(Ggx, MaskingKeepsTheProjectedArea) {
    for (const double cosine : {0.05, 0.3, 0.8, 1.0}) {
        const Vec w = direction(cosine, 0.7);
        for (const auto& [x, y] : {std::pair{0.3, 0.3}, {1.0, 1.0}, {0.2, 0.6}}) {
            const Ggx<double> facets(x, y);
            const double seen = hemisphere_integral(
                std::sqrt(x * y), [&](const Vec& m) { return facets.density(m) * std::max(0.0, w.dot(m)); });
            EXPECT_NEAR(facets.masking(w) * seen, cosine, 2e-4);
            EXPECT_NEAR(
                hemisphere_integral(std::sqrt(x * y), [&](const Vec& m) { return facets.visible_density(w, m); }), 1.0,
                5e-4 / cosine);
        }
    }
}

TEST(Ggx, FloatAgreesWithDouble) {
    Pcg32 random(5);
    for (int i = 0; i < 20000; ++i) {
        const float ax = 0.001f + random.next_float(), ay = 0.001f + random.next_float();
        const Vec w = direction(1e-3 + 0.999 * static_cast<double>(random.next_float()),
                                6.28 * static_cast<double>(random.next_float()));
        const Imath::V3f wf(w);
        const Ggx<float> single(ax, ay);
        const Ggx<double> exact(static_cast<double>(ax), static_cast<double>(ay));
        const Vec rounded(wf);
        EXPECT_NEAR(static_cast<double>(single.density(wf)) / exact.density(rounded), 1.0, 5e-6);
        EXPECT_NEAR(static_cast<double>(single.masking(wf)) / exact.masking(rounded), 1.0, 1e-6);
        const std::array<float, 2> u = {random.next_float(), random.next_float()};
        const Vec m(single.sample_visible(wf, u));
        const Vec m_exact = exact.sample_visible(rounded, {static_cast<double>(u[0]), static_cast<double>(u[1])});
        EXPECT_LT((m - m_exact).length(), 2e-3) << w << " " << ax << " " << ay;
    }
}

}  // namespace
}  // namespace emulsion
