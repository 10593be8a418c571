#pragma once
// Small geometry for the inner loop, on Imath's vectors.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Imath/ImathVec.h>

namespace emulsion {

[[nodiscard]] inline float max_abs_component(const Imath::V3f& v) noexcept {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// v / |v| for a v whose squared length neither overflows nor vanishes.
[[nodiscard]] inline Imath::V3f unit(const Imath::V3f& v) noexcept { return v * (1.0f / std::sqrt(v.dot(v))); }

/// Three unit vectors at right angles to each other; the normal is given.
/// Source: Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
struct Frame {
    Imath::V3f tangent, bitangent, normal;

    explicit Frame(const Imath::V3f& n) noexcept : normal(n) {
        const float sign = std::copysign(1.0f, n.z);
        const float a = -1.0f / (sign + n.z);
        const float b = n.x * n.y * a;
        tangent = {1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x};
        bitangent = {b, sign + n.y * n.y * a, -n.y};
    }
    /// With this tangent, a unit vector at right angles to the normal.
    Frame(const Imath::V3f& n, const Imath::V3f& t) noexcept : tangent(t), bitangent(n.cross(t)), normal(n) {}

    [[nodiscard]] Imath::V3f to_world(const Imath::V3f& local) const noexcept {
        return tangent * local.x + bitangent * local.y + normal * local.z;
    }
    [[nodiscard]] Imath::V3f to_local(const Imath::V3f& world) const noexcept {
        return {world.dot(tangent), world.dot(bitangent), world.dot(normal)};
    }
};

/// Uniform on the unit disk, from the unit square by concentric squares and circles.
/// Source: Shirley & Chiu, "A Low Distortion Map Between Disk and Square", JGT 2(3), 1997.
[[nodiscard]] inline std::array<float, 2> uniform_disk(std::array<float, 2> u) noexcept {
    const float a = 2.0f * u[0] - 1.0f, b = 2.0f * u[1] - 1.0f;
    const bool wide = std::abs(a) > std::abs(b);
    const float radius = wide ? a : b;
    const float ratio = wide ? b / a : (b == 0.0f ? 0.0f : a / b);
    // The angle lies in [-pi/4, pi/4], where these series are exact to a rounding or two.
    const float angle = 0.25f * std::numbers::pi_v<float> * ratio, s = angle * angle;
    const float sine = angle * (1.0f + s * (-1.0f / 6 + s * (1.0f / 120 + s * (-1.0f / 5040 + s * (1.0f / 362880)))));
    const float cosine = 1.0f + s * (-0.5f + s * (1.0f / 24 + s * (-1.0f / 720 + s * (1.0f / 40320))));
    return wide ? std::array{radius * cosine, radius * sine} : std::array{radius * sine, radius * cosine};
}

/// A direction about +z with density cos(theta)/pi.
[[nodiscard]] inline Imath::V3f cosine_hemisphere(std::array<float, 2> u) noexcept {
    const auto [x, y] = uniform_disk(u);
    return {x, y, std::sqrt(std::max(0.0f, 1.0f - x * x - y * y))};
}

/// A direction with density 1/(4 pi).
[[nodiscard]] inline Imath::V3f uniform_sphere(std::array<float, 2> u) noexcept {
    const float z = 1.0f - 2.0f * u[0];
    const float radius = std::sqrt(std::max(0.0f, 1.0f - z * z));
    const float angle = 2.0f * std::numbers::pi_v<float> * u[1];
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

/// Weight of a sample drawn with density `pdf` where another strategy draws with `other`.
/// Source: Veach & Guibas, "Optimally Combining Sampling Techniques for Monte Carlo Rendering", SIGGRAPH 1995, the
/// power heuristic with exponent 2.
[[nodiscard]] inline float power_heuristic(float pdf, float other) noexcept {
    // By the ratio, so that large densities do not overflow when squared.
    const float ratio = other / pdf;
    return 1.0f / (1.0f + ratio * ratio);
}

}  // namespace emulsion
