// The closed form of a coat over a diffuse base against what it stands for: a walk between the two, boundary by
// boundary, as Guo et al. 2018 and pbrt-v4 follow it.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "bsdf_cases.h"
#include "core/random.h"
#include "pathtracer/fresnel.h"
#include "pathtracer/vector_math.h"

namespace emulsion::testing {
namespace {

using Vec = Imath::V3d;
constexpr double kPi = std::numbers::pi;

struct Coat {
    double rho, eta, alpha, thickness;
    int max_depth;
    [[nodiscard]] bool smooth() const { return alpha < kSmoothAlpha; }
};

class Walk {
  public:
    Walk(const Coat& coat, std::uint64_t seed) : coat_(coat), facets_(coat.alpha, coat.alpha), random_(seed) {}

    /// Albedo seen from a direction with this cosine, without what the top of the coat reflects.
    double base_albedo(double cosine) {
        const Vec wo(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
        Vec down;
        double weight = refract_in(wo, down);
        for (int depth = 0; depth < coat_.max_depth && weight > 0.0; depth += 2) {
            weight *= std::exp(-coat_.thickness / std::abs(down.z)) * coat_.rho;
            const Vec up = lambertian();
            weight *= std::exp(-coat_.thickness / up.z);
            // The top: out, or back down.
            Vec next;
            bool leaves = false;
            weight *= at_top(up, next, leaves);
            if (leaves) return weight;
            down = next;
        }
        return 0.0;
    }

  private:
    double uniform() { return (static_cast<double>(random_.next()) + 0.5) * 0x1p-32; }
    Vec lambertian() {
        const double r = std::sqrt(uniform()), phi = 2.0 * kPi * uniform();
        return {r * std::cos(phi), r * std::sin(phi), std::sqrt(std::max(1e-30, 1.0 - r * r))};
    }
    Vec facet(const Vec& w) {
        if (coat_.smooth()) return {0, 0, 1};
        const double u = uniform();
        return facets_.sample_visible(w, {u, uniform()});
    }
    double masking(const Vec& a, const Vec& b) const {
        return coat_.smooth() ? 1.0 : facets_.masking_shadowing(a, b) / facets_.masking(a);
    }
    static Vec refracted(const Vec& w, const Vec& m, double cosine, double eta) {
        return -w / eta + m * (cosine / eta - std::sqrt(std::max(0.0, refracted_cosine2(cosine, eta))));
    }
    double refract_in(const Vec& wo, Vec& down) {
        const Vec m = facet(wo);
        const double cosine = wo.dot(m);
        down = refracted(wo, m, cosine, coat_.eta);
        return down.z < 0.0 ? (1.0 - fresnel_dielectric(cosine, coat_.eta)) * masking(wo, down) : 0.0;
    }
    double at_top(const Vec& up, Vec& next, bool& leaves) {
        const Vec m = facet(up);
        const double cosine = up.dot(m), reflectance = fresnel_dielectric(cosine, 1.0 / coat_.eta);
        leaves = uniform() >= reflectance;
        if (leaves) {
            const Vec out = refracted(up, m, cosine, 1.0 / coat_.eta);
            return out.z < 0.0 ? masking(up, out) : 0.0;
        }
        const Vec mirror = m * (2.0 * cosine) - up;
        next = {mirror.x, mirror.y, -mirror.z};
        return mirror.z > 0.0 ? masking(up, mirror) : 0.0;
    }

    Coat coat_;
    Ggx<double> facets_;
    Pcg32 random_;
};

struct Mean {
    double sum = 0.0, squares = 0.0;
    int count = 0;
    void add(double v) {
        sum += v;
        squares += v * v;
        ++count;
    }
    [[nodiscard]] double value() const { return sum / count; }
    [[nodiscard]] double error() const { return std::sqrt(std::max(0.0, squares / count - value() * value()) / count); }
};

/// Integral of f_cos over the hemisphere, without the coat's own reflection: uniform in cosine-weighted directions.
Mean our_base_albedo(const Coat& coat, double cosine, int draws) {
    CoatedDiffuseBsdf<1> bsdf;
    bsdf.reflectance = SampledSpectrum<1>(static_cast<float>(coat.rho));
    bsdf.eta = static_cast<float>(coat.eta);
    bsdf.thickness = static_cast<float>(coat.thickness);
    bsdf.terms = (coat.max_depth + 1) / 2;
    bsdf.facets = Ggx<float>(static_cast<float>(coat.alpha), static_cast<float>(coat.alpha));
    bsdf.smooth_coat = coat.smooth();
    bsdf.internal_reflectance = static_cast<float>(coat_internal_reflectance(coat.eta, coat.thickness));
    CoatedDiffuseBsdf<1> black = bsdf;
    black.reflectance = SampledSpectrum<1>(0.0f);

    const auto c = static_cast<float>(cosine);
    const Imath::V3f wo(std::sqrt(1.0f - c * c), 0.0f, c);
    Pcg32 random(77);
    Mean mean;
    for (int i = 0; i < draws; ++i) {
        const float u = random.next_float();
        const Imath::V3f wi = cosine_hemisphere({u, random.next_float()});
        bsdf.seed = black.seed = random.next();
        const float value = evaluate(bsdf, wo, wi).f_cos[0] - evaluate(black, wo, wi).f_cos[0];
        if (wi.z > 0.0f) mean.add(static_cast<double>(value / wi.z) * kPi);
    }
    return mean;
}

TEST(CoatedDiffuse, AlbedoIsThatOfTheWalk) {
    for (const Coat& coat : {Coat{0.5, 1.5, 0.0, 0.01, 10}, Coat{0.9, 1.5, 0.0, 0.01, 10},
                             Coat{0.9, 1.5, 0.0, 0.3, 100}, Coat{0.9, 1.8, 0.0, 0.0, 3}, Coat{0.9, 1.5, 0.3, 0.01, 10},
                             Coat{0.6, 1.3, 0.7, 0.1, 10}, Coat{0.8, 0.8, 0.2, 0.05, 9}}) {
        for (const double cosine : {0.15, 0.6, 1.0}) {
            Walk walk(coat, 5);
            Mean expected;
            for (int i = 0; i < 300000; ++i) expected.add(walk.base_albedo(cosine));
            const Mean ours = our_base_albedo(coat, cosine, 200000);
            EXPECT_NEAR(ours.value(), expected.value(), 4.5 * std::hypot(ours.error(), expected.error()) + 1e-5)
                << "rho " << coat.rho << " eta " << coat.eta << " alpha " << coat.alpha << " thickness "
                << coat.thickness << " cosine " << cosine;
        }
    }
}

// Without absorption, K is the known diffuse Fresnel reflectance from inside: 1 - (1 - F) / eta^2, F from outside.
TEST(CoatedDiffuse, InternalReflectanceOfAClearCoat) {
    for (const double eta : {1.1, 1.33, 1.5, 2.4}) {
        double outside = 0.0;
        constexpr int kSteps = 100000;
        for (int i = 0; i < kSteps; ++i) {
            const double c = (i + 0.5) / kSteps;
            outside += 2.0 * c * fresnel_dielectric(c, eta) / kSteps;
        }
        EXPECT_NEAR(coat_internal_reflectance(eta, 0.0), 1.0 - (1.0 - outside) / (eta * eta), 2e-6) << eta;
    }
    EXPECT_NEAR(coat_internal_reflectance(1.0, 0.5), 0.0, 1e-12);
    EXPECT_LT(coat_internal_reflectance(1.5, 0.2), coat_internal_reflectance(1.5, 0.1));
}

}  // namespace
}  // namespace emulsion::testing
