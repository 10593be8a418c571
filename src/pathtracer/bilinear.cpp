#include "pathtracer/bilinear.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace emulsion {

namespace {

using Imath::V2d;
using Imath::V3d;

/// Real roots of a + b x + c x^2, as many as there are.
struct Roots {
    std::array<double, 2> root;
    int count;
};
Roots roots_of(double a, double b, double c) noexcept {
    if (c == 0.0) return {{b == 0.0 ? 0.0 : -a / b, 0.0}, b == 0.0 ? 0 : 1};
    const double discriminant = b * b - 4.0 * a * c;
    if (discriminant < 0.0) return {{0.0, 0.0}, 0};
    // The larger root first, as no digits cancel there; the other by their product.
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    if (q == 0.0) return {{0.0, 0.0}, 1};
    return {{q / c, a / q}, 2};
}

/// Corners in the order of a walk round.
using Walk = std::array<V3d, 4>;

bool is_flat(const Walk& corner) noexcept {
    const V3d across = corner[2] - corner[0], back = corner[3] - corner[1];
    const double diagonal = std::max(across.length(), back.length());
    const V3d normal = across.cross(back);
    const double length = normal.length();
    return length == 0.0 || std::abs(normal.dot(corner[1] - corner[0])) <= 1e-5 * diagonal * length;
}

bool is_convex(const Walk& corner) noexcept {
    const V3d normal = (corner[2] - corner[0]).cross(corner[3] - corner[1]);
    const bool no_area = normal.dot(normal) == 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        const V3d in = corner[(i + 1) % 4] - corner[i], out = corner[(i + 2) % 4] - corner[(i + 1) % 4];
        const V3d turn = in.cross(out);
        // A bow tie may have no area on the whole, and straight corners may seem to turn by their rounding.
        const double slack = 1e-6 * in.length() * out.length();
        if (no_area ? turn.length() > slack : turn.dot(normal) < -slack * normal.length()) return false;
    }
    return true;
}

}  // namespace

BilinearPatch::BilinearPatch(const BilinearMesh& mesh, std::uint32_t patch) noexcept
    : p00(mesh.position[mesh.patch[patch][0]]),
      p10(mesh.position[mesh.patch[patch][1]]),
      p01(mesh.position[mesh.patch[patch][2]]),
      p11(mesh.position[mesh.patch[patch][3]]) {}

std::optional<BilinearHit> first_hit(const BilinearPatch& patch, const V3d& origin, const V3d& direction, double t_min,
                                     double t_max) noexcept {
    // The lines of constant u: those are met whose volume with the ray is 0, a quadratic equation in u.
    const V3d q00 = patch.p00 - origin, q10 = patch.p10 - origin;
    const V3d e00 = patch.p01 - patch.p00, e11 = patch.p11 - patch.p10;
    const double at_0 = q00.cross(direction).dot(e00), at_1 = q10.cross(direction).dot(e11);
    const double c = (patch.p10 - patch.p00).cross(patch.p01 - patch.p11).dot(direction);
    const Roots roots = roots_of(at_0, at_1 - at_0 - c, c);

    std::optional<BilinearHit> hit;
    for (int i = 0; i < roots.count; ++i) {
        const double u = roots.root[static_cast<std::size_t>(i)];
        if (!(u >= 0.0 && u <= 1.0)) continue;
        const V3d from = q00 * (1.0 - u) + q10 * u, along = e00 * (1.0 - u) + e11 * u;
        const V3d n = direction.cross(along);
        const double length2 = n.length2();
        if (!(length2 > 0.0)) continue;
        const V3d m = n.cross(from);
        const double t = m.dot(along) / length2, v = m.dot(direction) / length2;
        if (!(v >= 0.0 && v <= 1.0 && t > t_min && t < t_max)) continue;
        hit = BilinearHit{t, u, v};
        t_max = t;
    }
    return hit;
}

V2d patch_uv(const BilinearPatch& patch, const V3d& position) noexcept {
    // Newton's method, on what of the distance lies in the tangent plane.
    V2d uv(0.5, 0.5);
    for (int step = 0; step < 12; ++step) {
        const V3d miss = position - patch.at(uv.x, uv.y), du = patch.dp_du(uv.y), dv = patch.dp_dv(uv.x);
        const double uu = du.length2(), vv = dv.length2(), cross = du.dot(dv);
        const double determinant = uu * vv - cross * cross;
        if (!(determinant > 1e-24 * uu * vv)) break;
        const double mu = miss.dot(du), mv = miss.dot(dv);
        const V2d move = V2d(mu * vv - mv * cross, mv * uu - mu * cross) * (1.0 / determinant);
        uv = {std::clamp(uv.x + move.x, 0.0, 1.0), std::clamp(uv.y + move.y, 0.0, 1.0)};
        if (std::max(std::abs(move.x), std::abs(move.y)) < 1e-9) break;
    }
    return uv;
}

bool is_flat_and_convex(const BilinearPatch& patch) noexcept {
    const Walk round = {patch.p00, patch.p10, patch.p11, patch.p01};
    return is_flat(round) && is_convex(round);
}

double area_of(const BilinearPatch& patch) noexcept {
    if (patch.p00 + patch.p11 == patch.p10 + patch.p01) return patch.cross(0.0, 0.0).length();
    double area = 0.0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const double u0 = i / 3.0, u1 = (i + 1) / 3.0, v0 = j / 3.0, v1 = (j + 1) / 3.0;
            const V3d across = patch.at(u1, v1) - patch.at(u0, v0), back = patch.at(u1, v0) - patch.at(u0, v1);
            area += 0.5 * across.cross(back).length();
        }
    }
    return area;
}

Imath::Box3f bounds(const BilinearPatch& patch) noexcept {
    // A patch lies within its corners' hull. They were single precision before.
    Imath::Box3f box;
    for (const V3d& corner : {patch.p00, patch.p10, patch.p01, patch.p11}) box.extendBy(Imath::V3f(corner));
    return box;
}

}  // namespace emulsion
