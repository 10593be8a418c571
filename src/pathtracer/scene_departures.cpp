#include "pathtracer/scene_departures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/units.h"

namespace emulsion {

namespace {

/// Whether a transformation of directions is a rotation, mirrored or not.
bool keeps_lengths(const Imath::M44d& m) noexcept {
    constexpr double kTolerance = 1e-3;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            double product = 0.0;
            for (int k = 0; k < 3; ++k) product += m[i][k] * m[j][k];
            if (std::abs(product - (i == j ? 1.0 : 0.0)) > kTolerance) return false;
        }
    }
    return true;
}

bool is_whole(const Sphere& sphere) noexcept {
    return sphere.z_min <= -sphere.radius && sphere.z_max >= sphere.radius && sphere.phi_max >= 2.0 * std::numbers::pi;
}
bool is_whole(const Disk& disk) noexcept { return disk.inner_radius == 0.0 && disk.phi_max >= 2.0 * std::numbers::pi; }
bool is_whole(const Cylinder& /*cylinder*/) noexcept { return true; }  // pbrt-v4 samples its sector alone, too

template <class Quadric>
std::string departure(const Quadric& quadric) {
    if (!keeps_lengths(quadric.world_from_object)) {
        return "a scaled shape shines as its true area does; pbrt-v4 takes its area before the transformation where it "
               "samples the light";
    }
    if (!is_whole(quadric)) return "a part of a shape shines alone; pbrt-v4 samples the whole of it as a light";
    return {};
}

/// Whether a table ends within the visible, where pbrt-v4 has 0 for it.
bool ends_within_visible(const Spectrum& spectrum) {
    const auto* table = std::get_if<PiecewiseLinearSpectrum>(&spectrum);
    if (table == nullptr || table->extrapolation != Extrapolation::zero) return false;
    return table->lambda_nm.front() > kMinWavelength_nm || table->lambda_nm.back() < kMaxWavelength_nm;
}

}  // namespace

std::string departure_of_light(const Geometry& geometry) {
    return std::visit(
        [](const auto& shape) -> std::string {
            if constexpr (requires { shape.world_from_object; }) return departure(shape);
            return {};
        },
        geometry);
}

std::string departure_of(const Material& material) {
    const auto* conductor = std::get_if<ConductorMaterial>(&material);
    const auto* ior = conductor == nullptr ? nullptr : std::get_if<ComplexIor>(&conductor->ior);
    if (ior == nullptr || !(ends_within_visible(ior->eta) && ends_within_visible(ior->k))) return {};
    return "eta and k end within 360 to 830 nm and are 0 beyond: the metal reflects all light there; pbrt-v4 has no "
           "number for it";
}

}  // namespace emulsion
