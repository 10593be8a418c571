#pragma once
// Scenes small enough to know their radiance, and the means to measure it path by path.

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "pathtracer/path_integrator.h"
#include "pathtracer/prepared_scene.h"

namespace emulsion::testing {

/// Wavelengths at which the tests look, nm.
inline constexpr std::array<float, 4> kTestWavelengths_nm = {420.0f, 500.0f, 580.0f, 660.0f};

/// A spectrum that differs at every wavelength: from `at_400` to `at_700` in a straight line.
inline PiecewiseLinearSpectrum slope(double at_400, double at_700) { return {{400.0, 700.0}, {at_400, at_700}}; }

/// A parallelogram of two triangles; its normal is edge1 x edge2.
inline TriangleMesh parallelogram(Imath::V3f corner, Imath::V3f edge1, Imath::V3f edge2) {
    TriangleMesh mesh;
    mesh.position = {corner, corner + edge1, corner + edge1 + edge2, corner + edge2};
    mesh.triangle = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

/// The cube [-1, 1]^3 with its normals inwards, as one mesh.
inline TriangleMesh inward_box() {
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.position.emplace_back((i & 1) != 0 ? 1.0f : -1.0f, (i & 2) != 0 ? 1.0f : -1.0f,
                                   (i & 4) != 0 ? 1.0f : -1.0f);
    }
    const auto quad = [&mesh](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        mesh.triangle.push_back({a, b, c});
        mesh.triangle.push_back({a, c, d});
    };
    quad(0, 1, 3, 2);  // z = -1, normal +z
    quad(4, 6, 7, 5);  // z = +1
    quad(0, 4, 5, 1);  // y = -1
    quad(2, 3, 7, 6);  // y = +1
    quad(0, 2, 6, 4);  // x = -1
    quad(1, 5, 7, 3);  // x = +1
    return mesh;
}

/// Form factor of a rectangle a x b, parallel at height 1 over the point below one of its corners, from that point.
/// Source: Howell, "A Catalog of Radiation Heat Transfer Configuration Factors", B-4.
inline double corner_form_factor(double a, double b) {
    const double x = std::sqrt(1.0 + a * a), y = std::sqrt(1.0 + b * b);
    return (a / x * std::atan(b / x) + b / y * std::atan(a / y)) / (2.0 * std::numbers::pi);
}

/// Mean and standard error of the radiance along a ray, wavelength by wavelength.
struct RadianceEstimate {
    std::array<double, 4> mean{}, standard_error{};
};

inline RadianceEstimate estimate_radiance(const Scene& scene, const Ray& ray, int count, const Sampler& sampler = {},
                                          std::uint64_t seed = 1) {
    const PreparedScene prepared(scene, 1);
    PathIntegrator<SpectralTransport<4>> integrator(prepared, scene.integrator.max_depth);
    std::array<double, 4> sum{}, sum_of_squares{};
    constexpr int kBatch = 256;
    for (int begin = 0; begin < count; begin += kBatch) {
        std::vector<Path<SpectralTransport<4>>> paths(static_cast<std::size_t>(std::min(kBatch, count - begin)));
        for (std::size_t i = 0; i < paths.size(); ++i) {
            paths[i].ray = ray;
            paths[i].samples = SampleSequence(sampler, seed, 0, 0, begin + static_cast<int>(i));
            paths[i].wavelengths.lambda_nm = kTestWavelengths_nm;
            paths[i].wavelengths.pdf.fill(1.0f);
            paths[i].index = SpectrumTableIndex<4>(kTestWavelengths_nm);
        }
        integrator.trace(paths);
        for (const auto& path : paths) {
            for (std::size_t i = 0; i < 4; ++i) {
                const auto value = static_cast<double>(path.radiance.value[i]);
                sum[i] += value;
                sum_of_squares[i] += value * value;
            }
        }
    }
    RadianceEstimate estimate;
    for (std::size_t i = 0; i < 4; ++i) {
        estimate.mean[i] = sum[i] / count;
        const double variance = std::max(0.0, sum_of_squares[i] / count - estimate.mean[i] * estimate.mean[i]);
        estimate.standard_error[i] = std::sqrt(variance / (count - 1));
    }
    return estimate;
}

}  // namespace emulsion::testing
