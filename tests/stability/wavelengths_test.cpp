// Wavelengths of paths: lines that few of them find, dispersion, the noise of colours, and the ends of the
// visible.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "film/film.h"
#include "noisy_grey.h"
#include "pathtracer/path_integrator.h"
#include "pathtracer/prepared_scene.h"
#include "spectrum/catalogue.h"
#include "spectrum/cielab.h"
#include "spectrum/color_difference.h"
#include "spectrum/colorimetry.h"
#include "spectrum/integral.h"
#include "spectrum/wavelength_sampler.h"

namespace emulsion {
namespace {

// --- Lines

/// Relative RMS error and relative error of the mean of Y, over 40000 estimates of four wavelengths.
struct Errors {
    double rms = 0.0, bias = 0.0;
};

Errors errors_of_y(const WavelengthStrategy& strategy, const Spectrum& continuum, const std::vector<Line>& lines) {
    const Spectrum lamp = sum_of(continuum, LineSpectrum{lines, {}});
    const double exact = integral_with_observer({lamp}, cie_1931_2deg()).y;
    const WavelengthSampler sampler = prepare(strategy, wavelength_importance(lamp));
    constexpr int kEstimates = 40000;
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < kEstimates; ++i) {
        const auto paths = sample_wavelengths<4>(sampler, [i] { return (static_cast<float>(i) + 0.5f) / kEstimates; });
        double y = 0.0;
        for (std::size_t k = 0; k < 4; ++k) {
            const auto lambda_nm = static_cast<double>(paths.lambda_nm[k]);
            const double radiance = paths.line[k] == kNoLine ? eval(continuum, lambda_nm)
                                                             : lines[static_cast<std::size_t>(paths.line[k])].power;
            y += 0.25 * radiance * eval(cie_1931_2deg(), lambda_nm).y / static_cast<double>(paths.pdf[k]);
        }
        sum += y / kEstimates;
        squares += (y - exact) * (y - exact) / kEstimates;
    }
    return {std::sqrt(squares) / exact, sum / exact - 1.0};
}

// No density ever draws a line without width: its light is missing however many samples there are, and no noise tells.
TEST(Lines, WithoutWidthAreMissedByDensities) {
    const std::vector<Line> mercury = {{435.833, 6.0}, {546.074, 12.0}, {578.013, 9.0}};
    const Spectrum lamp = BlackbodySpectrum{3000.0};
    const Errors missed = errors_of_y(HeroUniform{}, lamp, mercury), found = errors_of_y(HeroLines{}, lamp, mercury);
    EXPECT_NEAR(missed.bias, -0.309, 0.001);
    EXPECT_NEAR(found.bias, 0.0, 0.001);
    EXPECT_NEAR(found.rms, 0.061, 0.001);
}

// --- Dispersion

/// A pane of flint before a sky of 1. Whatever is reflected and refracted, all of it ends in the sky.
Scene flint_pane() {
    DielectricMaterial flint;
    flint.eta = PiecewiseLinearSpectrum({{400.0, 700.0}, {1.9, 1.6}});
    const auto face = [](float z, Imath::V3f a, Imath::V3f b) {
        const Imath::V3f corner(-5e3f, -5e3f, z);
        TriangleMesh mesh;
        mesh.position = {corner, corner + a, corner + a + b, corner + b};
        mesh.triangle = {{0, 1, 2}, {0, 2, 3}};
        return mesh;
    };
    const Imath::V3f x(1e4f, 0, 0), y(0, 1e4f, 0);
    Scene scene;
    scene.materials = {flint};
    scene.shapes = {{face(0.0f, y, x), 0, {}}, {face(1.0f, x, y), 0, {}}};
    scene.lights = {UniformInfiniteLight{{ConstantSpectrum{1.0}, 1.0}}};
    scene.integrator.max_depth = 30;
    return scene;
}

// Behind the first refraction a path has one wavelength left of four. It stands for all of them, and carries four times
// its own light; an integrator that only sets the others to 0 loses three quarters of
// it: 0.25 + 0.75 * 0.08 are left, as 8 % of the light is reflected at once.
TEST(Dispersion, WavelengthsThatEndLeaveTheirShareToTheOneThatGoesOn) {
    const Scene scene = flint_pane();
    const PreparedScene prepared(scene, 1);
    PathIntegrator<SpectralTransport<4>> integrator(prepared, scene.integrator.max_depth);
    constexpr int kPaths = 1 << 14;
    std::vector<Path<SpectralTransport<4>>> paths(kPaths);
    for (int i = 0; i < kPaths; ++i) {
        auto& path = paths[static_cast<std::size_t>(i)];
        path.ray = Ray{{0, 0, -5}, Imath::V3f(0.5f, 0.2f, 1.0f).normalized()};
        path.samples = SampleSequence(IndependentSampler{}, 3, 0, 0, i);
        path.wavelengths = hero_wavelengths<4>(VisibleWavelengthPdf{}, (static_cast<float>(i) + 0.5f) / kPaths);
        path.index = SpectrumTableIndex<4>(path.wavelengths.lambda_nm);
    }
    integrator.trace(paths);
    Film naive({1, 1, {}}), ours({1, 1, {}});
    FilmTile naive_tile = naive.make_tile(naive.bounds()), our_tile = ours.make_tile(ours.bounds());
    for (const auto& path : paths) {
        const float share = path.channels == Channels::first_only ? 0.25f : 1.0f;
        naive_tile.add(0, 0, path.wavelengths, share * path.radiance, 1.0f);
        our_tile.add(0, 0, path.wavelengths, path.radiance, 1.0f);
    }
    naive.merge(naive_tile), ours.merge(our_tile);
    const auto sky = static_cast<float>(xyz_of_radiance(ConstantSpectrum{1.0}).y);
    EXPECT_NEAR(naive.xyz_image()(0, 0).y / sky, 0.31f, 0.01f);
    EXPECT_NEAR(ours.xyz_image()(0, 0).y / sky, 1.0f, 0.01f);
}

// --- The noise of colours

/// The mean chroma C*ab of 400 grey pixels of reflectance 1/2 under D65, each of 16 paths.
template <int N>
double grey_chroma(const WavelengthStrategy& strategy) {
    const stability::NoisyGrey<N> grey(strategy, catalogue_spectrum("D65"));
    Pcg32 random(5);
    double chroma = 0.0;
    for (int pixel = 0; pixel < 400; ++pixel) {
        chroma += lch_from_lab(lab_from_xyz(grey.pixel(16, random), grey.white())).chroma / 400.0;
    }
    return chroma;
}

TEST(ChromaticNoise, OfOneWavelengthIsFarAboveThatOfFour) {
    EXPECT_NEAR(grey_chroma<1>(IndependentUniform{}), 52.6, 0.1);
    EXPECT_NEAR(grey_chroma<1>(HeroVisible{}), 40.2, 0.1);
    EXPECT_NEAR(grey_chroma<4>(HeroVisible{}), 5.61, 0.05);
    EXPECT_NEAR(grey_chroma<8>(HeroVisible{}), 0.786, 0.01);
}

// --- The ends of the visible

struct Cut {
    double mean = 0.0, largest = 0.0;
};

/// CIEDE2000 of the 24 patches under a light, as seen from 380 to 730 nm, from how they look.
Cut cut_to_380_730(const char* light_name) {
    const Spectrum light = catalogue_spectrum(light_name);
    const XYZd white = xyz_of_reflectance(ConstantSpectrum{1.0}, light);
    Cut cut;
    int count = 0;
    for (const NamedSpectrumInfo& entry : spectrum_catalogue()) {
        if (!entry.name.starts_with("colorchecker-")) continue;
        const Spectrum patch = spectrum_of(entry);
        const XYZd exact = xyz_of_reflectance(patch, light);
        // Integrals, each over that of the light with ybar over the same range.
        const double y = xyz_by_summation(ConstantSpectrum{1.0}, light, cie_1931_2deg(), 380.0, 730.0, 1.0).y;
        const XYZd cut_off = 1.0 / y * xyz_by_summation(patch, light, cie_1931_2deg(), 380.0, 730.0, 1.0);
        const double d = difference(Ciede2000Difference{}, lab_from_xyz(exact, white), lab_from_xyz(cut_off, white));
        cut.mean += d / 24.0;
        cut.largest = std::max(cut.largest, d);
        ++count;
    }
    EXPECT_EQ(count, 24);
    return cut;
}

TEST(WavelengthRange, CutAt380And730LosesTheTails) {
    const Cut d65 = cut_to_380_730("D65"), a = cut_to_380_730("A");
    EXPECT_NEAR(d65.mean, 0.010, 0.001);
    EXPECT_NEAR(d65.largest, 0.019, 0.001);
    EXPECT_NEAR(a.mean, 0.025, 0.001);
    EXPECT_NEAR(a.largest, 0.054, 0.001);
    // What a dark red filter, from 690 nm on, lets through of A has lost a tenth of its luminance.
    const Spectrum filtered =
        product_of(catalogue_spectrum("A"), PiecewiseLinearSpectrum({{690.0, 700.0, 830.0}, {0.0, 1.0, 1.0}}));
    EXPECT_NEAR(
        xyz_of_radiance_by_summation(filtered, cie_1931_2deg(), 380.0, 730.0, 1.0).y / xyz_of_radiance(filtered).y,
        0.910, 0.001);
    // A lamp of 740 nm is black there; ours ends where the observer's table does.
    const Spectrum far_red = LineSpectrum{{}, {GaussianLine{740.0, 2.0, 1.0}}};
    EXPECT_LT(xyz_of_radiance_by_summation(far_red, cie_1931_2deg(), 380.0, 730.0, 0.1).y, 1e-6);
    EXPECT_NEAR(xyz_of_radiance(far_red).y, 683.0 * eval(cie_1931_2deg(), 740.0).y, 0.01);
    EXPECT_EQ(kMinWavelength_nm, cie_1931_2deg().first_nm);
    EXPECT_EQ(kMaxWavelength_nm, cie_1931_2deg().last_nm());
}

}  // namespace
}  // namespace emulsion
