#pragma once
// The GGX (Trowbridge-Reitz) distribution of microfacets, anisotropic, and the masking of one by another according to
// Smith. Directions are unit vectors in the surface's frame, z along its normal, x and y along its tangents. T is float
// in the renderer and double in the reference twin.
// Source: Walter et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007; Heitz, "Understanding
// the Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2), 2014.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Imath/ImathVec.h>

namespace emulsion {

/// Both alphas below this: the surface is a mirror.
inline constexpr double kSmoothAlpha = 1e-3;
/// Smaller ones (of the other tangent) are raised to this.
inline constexpr double kLeastAlpha = 1e-4;

template <class T>
class Ggx {
  public:
    using Vec = Imath::Vec3<T>;

    Ggx() = default;
    Ggx(T alpha_x, T alpha_y) noexcept
        : alpha_x_(std::max(alpha_x, T(kLeastAlpha))), alpha_y_(std::max(alpha_y, T(kLeastAlpha))) {}

    /// Density of microfacets by their normal: the area of those about `m`, per steradian and unit of surface. Its
    /// integral times the cosine over the hemisphere is 1. (Heitz 2014, eq. 85.)
    [[nodiscard]] T density(const Vec& m) const noexcept {
        if (!(m.z > T(0))) return T(0);
        // |(m.x / ax, m.y / ay, m.z)|^2, the squared length of the normal on the stretched hemisphere.
        const T x = m.x / alpha_x_, y = m.y / alpha_y_, length2 = x * x + y * y + m.z * m.z;
        return T(1) / (std::numbers::pi_v<T> * alpha_x_ * alpha_y_ * length2 * length2);
    }

    /// (-1 + sqrt(1 + a^2 tan^2)) / 2, the ratio of masked to visible area. (Heitz 2014, eq. 72.)
    [[nodiscard]] T lambda(const Vec& w) const noexcept {
        const T z2 = w.z * w.z;
        if (!(z2 > T(0))) return std::numeric_limits<T>::infinity();
        const T x = alpha_x_ * w.x, y = alpha_y_ * w.y, tan2 = (x * x + y * y) / z2;
        // As a quotient, so that nothing cancels for small ones.
        return T(0.5) * tan2 / (T(1) + std::sqrt(T(1) + tan2));
    }

    /// The share of microfacets that is seen from w.
    [[nodiscard]] T masking(const Vec& w) const noexcept { return T(1) / (T(1) + lambda(w)); }
    /// That is seen from both, correlated by height. (Heitz 2014, eq. 99; for directions on either side.)
    [[nodiscard]] T masking_shadowing(const Vec& wo, const Vec& wi) const noexcept {
        return T(1) / (T(1) + lambda(wo) + lambda(wi));
    }

    /// Density, per steradian, with which sample_visible draws m.
    [[nodiscard]] T visible_density(const Vec& wo, const Vec& m) const noexcept {
        const T cosine = std::max(T(0), wo.dot(m));
        return masking(wo) * density(m) * cosine / std::abs(wo.z);
    }

    /// Draws a microfacet normal among those that wo sees; wo.z > 0.
    /// Source: Dupuy & Benyoub, "Sampling Visible GGX Normals with Spherical Caps", HPG 2023.
    [[nodiscard]] Vec sample_visible(const Vec& wo, std::array<T, 2> u) const noexcept {
        // On the unit hemisphere, which the surface's stretching makes of the ellipsoid of normals, a reflected
        // direction is uniform on a spherical cap; the half vector of it and wo is the normal.
        const Vec stretched = Vec(alpha_x_ * wo.x, alpha_y_ * wo.y, wo.z).normalized();
        const T z = (T(1) - u[1]) * (T(1) + stretched.z) - stretched.z;
        const T sine = std::sqrt(std::clamp(T(1) - z * z, T(0), T(1)));
        const T angle = T(2) * std::numbers::pi_v<T> * u[0];
        const Vec half = Vec(sine * std::cos(angle), sine * std::sin(angle), z) + stretched;
        const Vec m(alpha_x_ * half.x, alpha_y_ * half.y, std::max(half.z, T(0)));
        const T length2 = m.dot(m);
        return length2 > T(0) ? m * (T(1) / std::sqrt(length2)) : Vec(0, 0, 1);
    }

  private:
    T alpha_x_ = T(1), alpha_y_ = T(1);
};

/// alpha of a roughness that is given on a scale from 0, smooth, to 1. Source: as pbrt-v4 remaps it.
[[nodiscard]] inline float alpha_of_roughness(float roughness) noexcept { return std::sqrt(roughness); }

}  // namespace emulsion
