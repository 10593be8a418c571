// Paths through glass whose index depends on the wavelength carry one wavelength on for all. What they find must be, in
// the mean over the arrangement of the wavelengths, what each finds alone.

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "analytic_scenes.h"

namespace emulsion::testing {
namespace {

/// A ball of heavy flint before a floor and a lamp, all of which differ by wavelength.
Scene flint_scene(const Roughness& roughness) {
    Scene scene;
    DielectricMaterial flint;
    flint.eta = slope(1.9, 1.6);
    flint.roughness = roughness;
    scene.materials = {flint, DiffuseMaterial{Spectrum(slope(0.2, 0.9))}};
    scene.shapes = {{Sphere{}, 0, {}},
                    {parallelogram({-9, -9, -1.5f}, {18, 0, 0}, {0, 18, 0}), 1, {}},
                    {parallelogram({1, -2, 3}, {0, 4, 0}, {3, 0, 0}), 1, AreaLight{{slope(5.0, 9.0), 1.0}, true}}};
    scene.lights = {UniformInfiniteLight{{slope(0.5, 0.2), 1.0}}};
    scene.integrator.max_depth = 12;
    return scene;
}

const std::array kRays = {Ray{{-6, 0.3f, 1.0f}, Imath::V3f(6, 0, -1).normalized()},
                          Ray{{-6, 0.6f, 0.4f}, Imath::V3f(1, 0, 0)}};

struct Estimate {
    double sum = 0.0, squares = 0.0;
    int count = 0;
    void add(double value) {
        sum += value;
        squares += value * value;
        ++count;
    }
    [[nodiscard]] double mean() const { return sum / count; }
    [[nodiscard]] double standard_error() const {
        return std::sqrt(std::max(0.0, squares / count - mean() * mean()) / (count - 1));
    }
};

/// Of each of the test wavelengths, on paths of N that begin with each of them in turn.
template <int N>
std::array<Estimate, 4> estimate_by_rotation(const Scene& scene, const Ray& ray, int count) {
    const PreparedScene prepared(scene, 1);
    PathIntegrator<SpectralTransport<N>> integrator(prepared, scene.integrator.max_depth);
    std::array<Estimate, 4> estimates;
    std::vector<Path<SpectralTransport<N>>> paths(256);
    for (int begin = 0; begin < count; begin += 256) {
        for (std::size_t i = 0; i < paths.size(); ++i) {
            auto& path = paths[i] = {};
            path.ray = ray;
            path.samples = SampleSequence(IndependentSampler{}, 5 + N, 0, 0, begin + static_cast<int>(i));
            for (std::size_t k = 0; k < N; ++k) path.wavelengths.lambda_nm[k] = kTestWavelengths_nm[(i + k) % 4];
            path.wavelengths.pdf.fill(1.0f);
            path.index = SpectrumTableIndex<N>(path.wavelengths.lambda_nm);
        }
        integrator.trace(paths);
        for (std::size_t i = 0; i < paths.size(); ++i) {
            for (std::size_t k = 0; k < N; ++k) {
                estimates[(i + k) % 4].add(static_cast<double>(paths[i].radiance.value[k]));
            }
        }
    }
    return estimates;
}

void expect_same_as_alone(const Roughness& roughness, int count) {
    const Scene scene = flint_scene(roughness);
    for (const Ray& ray : kRays) {
        const auto together = estimate_by_rotation<4>(scene, ray, count);
        const auto alone = estimate_by_rotation<1>(scene, ray, count);
        for (std::size_t i = 0; i < 4; ++i) {
            const double error = std::hypot(together[i].standard_error(), alone[i].standard_error());
            EXPECT_NEAR(together[i].mean(), alone[i].mean(), 4.5 * error) << kTestWavelengths_nm[i] << " nm";
            EXPECT_LT(error, 0.02 * alone[i].mean());
        }
    }
}

TEST(Dispersion, SmoothGlassShowsEachWavelengthAsItIsAlone) { expect_same_as_alone({}, 400000); }
TEST(Dispersion, RoughGlassToo) { expect_same_as_alone({0.15, 0.15, false}, 400000); }

// A spectrum that is the same everywhere disperses nothing, however it is written: a table's jumps outside the visible
// are none.
TEST(Dispersion, ConstantTablesDoNotDisperse) {
    Scene scene = flint_scene({});
    for (const auto& [eta, channels] : {std::pair{PiecewiseLinearSpectrum({{300, 900}, {1.5, 1.5}}), Channels::all},
                                        {slope(1.9, 1.6), Channels::first_only}}) {
        std::get<DielectricMaterial>(scene.materials[0]).eta = eta;
        const PreparedScene prepared(scene, 1);
        PathIntegrator<SpectralTransport<4>> integrator(prepared, scene.integrator.max_depth);
        std::vector<Path<SpectralTransport<4>>> paths(64);
        for (std::size_t i = 0; i < paths.size(); ++i) {
            paths[i].ray = kRays[1];
            paths[i].samples = SampleSequence(IndependentSampler{}, 1, 0, 0, static_cast<int>(i));
            paths[i].index = SpectrumTableIndex<4>(kTestWavelengths_nm);
        }
        integrator.trace(paths);
        const auto is_it = [&channels = channels](const auto& path) { return path.channels == channels; };
        EXPECT_GT(std::count_if(paths.begin(), paths.end(), is_it), 50);
    }
}

// Paths that only reflect keep all of their wavelengths.
TEST(Dispersion, ReflectionsKeepTheirWavelengths) {
    Scene scene = flint_scene({});
    scene.shapes.resize(1);
    scene.lights = {UniformInfiniteLight{{ConstantSpectrum{1.0}, 1.0}}};
    scene.integrator.max_depth = 1;  // reflected at once, or inside the glass
    const auto estimates = estimate_by_rotation<4>(scene, kRays[1], 256 * 40);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_GT(estimates[i].mean(), 0.04);
    const PreparedScene prepared(scene, 1);
    PathIntegrator<SpectralTransport<4>> integrator(prepared, 1);
    std::vector<Path<SpectralTransport<4>>> paths(256);
    for (std::size_t i = 0; i < paths.size(); ++i) {
        paths[i].ray = kRays[1];
        paths[i].samples = SampleSequence(IndependentSampler{}, 1, 0, 0, static_cast<int>(i));
        paths[i].wavelengths.lambda_nm = kTestWavelengths_nm;
        paths[i].index = SpectrumTableIndex<4>(kTestWavelengths_nm);
    }
    integrator.trace(paths);
    int reflected = 0;
    for (const auto& path : paths) {
        if (path.radiance.max() == 0.0f) continue;
        ++reflected;
        for (const float value : path.radiance.value) EXPECT_GT(value, 0.0f);
        EXPECT_EQ(path.channels, Channels::all);
    }
    EXPECT_GT(reflected, 5);
}

}  // namespace
}  // namespace emulsion::testing
