// A closed room whose walls have albedo a and emit L: the radiance is L/(1 - a) everywhere and in every direction.

#include <gtest/gtest.h>

#include "analytic_scenes.h"
#include "pathtracer/render.h"
#include "spectrum/colorimetry.h"

namespace emulsion::testing {
namespace {

enum class Room { box, sphere };

Shape room_shape(Room room) {
    Shape shape;
    if (room == Room::box) {
        shape.geometry = inward_box();
    } else {
        shape.geometry = Sphere{.world_from_object = {}, .radius = 1.0, .flip_normal = true};
    }
    return shape;
}

Scene furnace(Room room, const Spectrum& albedo, const Spectrum& emission) {
    Scene scene;
    scene.materials = {DiffuseMaterial{albedo}};
    scene.shapes = {room_shape(room)};
    scene.shapes[0].area_light = AreaLight{{emission, 1.0}};
    scene.integrator.max_depth = 10000;
    return scene;
}

using FurnaceParameter = std::tuple<Room, double>;

class Furnace : public ::testing::TestWithParam<FurnaceParameter> {};

TEST_P(Furnace, RadianceIsEmissionOverOneMinusAlbedo) {
    const auto [room, albedo] = GetParam();
    const PiecewiseLinearSpectrum emission = slope(2.0, 5.0);
    const Scene scene = furnace(room, ConstantSpectrum{albedo}, emission);
    const Imath::V3f places[] = {{0.1f, -0.2f, 0.3f}, {0.7f, 0.05f, -0.6f}};
    const Imath::V3f directions[] = {{0.0f, 0.6f, 0.8f}, {-0.8f, 0.0f, -0.6f}};
    for (int k = 0; k < 2; ++k) {
        const auto estimate = estimate_radiance(scene, {places[k], directions[k]}, 20000);
        for (std::size_t i = 0; i < 4; ++i) {
            const double expected = eval(emission, static_cast<double>(kTestWavelengths_nm[i])) / (1.0 - albedo);
            // 4 standard errors: false alarm 6e-5 each; rounding in single precision adds 1e-6 a bounce.
            EXPECT_NEAR(estimate.mean[i], expected, 4.0 * estimate.standard_error[i] + 2e-6 * expected)
                << kTestWavelengths_nm[i] << " nm";
        }
    }
}

TEST_P(Furnace, AlbedoMayDifferByWavelength) {
    const auto [room, albedo] = GetParam();
    const PiecewiseLinearSpectrum emission = slope(1.0, 0.5), reflectance = slope(0.2, albedo);
    const auto estimate = estimate_radiance(furnace(room, reflectance, emission), {{0, 0, 0}, {1, 0, 0}}, 20000);
    for (std::size_t i = 0; i < 4; ++i) {
        const auto lambda_nm = static_cast<double>(kTestWavelengths_nm[i]);
        const double expected = eval(emission, lambda_nm) / (1.0 - eval(reflectance, lambda_nm));
        EXPECT_NEAR(estimate.mean[i], expected, 4.0 * estimate.standard_error[i] + 2e-6 * expected)
            << lambda_nm << " nm";
    }
}

INSTANTIATE_TEST_SUITE_P(Rooms, Furnace,
                         ::testing::Combine(::testing::Values(Room::box, Room::sphere),
                                            ::testing::Values(0.0, 0.5, 0.9)));

/// Far from the origin, positions are rounded to a good part of the room: points of the wall must not fall out of it.
TEST(FurnaceFarAway, IsAsBrightAsAtTheOrigin) {
    for (const float away : {10.0f, 100.0f, 1000.0f, 10000.0f}) {
        for (const bool two_sided : {false, true}) {
            Scene scene = furnace(Room::sphere, ConstantSpectrum{0.5}, ConstantSpectrum{10.0});
            auto& sphere = std::get<Sphere>(scene.shapes[0].geometry);
            sphere.world_from_object.setTranslation(Imath::V3d(static_cast<double>(away)));
            sphere.radius = 3.0;
            scene.shapes[0].area_light->two_sided = two_sided;
            const Imath::V3f inside(away, away + 0.5f, away - 0.25f);
            const auto estimate = estimate_radiance(scene, {inside, {0.6f, 0, 0.8f}}, 100000);
            EXPECT_NEAR(estimate.mean[1], 20.0, 4.0 * estimate.standard_error[1] + 1e-4) << away;
            EXPECT_LT(estimate.standard_error[1], 0.05);
        }
    }
}

/// Shorter paths gather a partial sum of the geometric series.
TEST(FurnaceDepth, EachScatteringEventAddsOneTerm) {
    for (const int depth : {0, 1, 2, 3}) {
        Scene scene = furnace(Room::box, ConstantSpectrum{0.5}, ConstantSpectrum{1.0});
        scene.integrator.max_depth = depth;
        const auto estimate = estimate_radiance(scene, {{0, 0, 0}, {0, 0, 1}}, 20000);
        const double expected = 2.0 - std::pow(0.5, depth);
        EXPECT_NEAR(estimate.mean[1], expected, 4.0 * estimate.standard_error[1] + 2e-6) << "max_depth " << depth;
    }
}

/// The whole way through camera, filter, wavelengths and film: XYZ of every pixel, and of their mean.
TEST(FurnaceFilm, PixelsHoldTheXyzOfTheRadiance) {
    const PiecewiseLinearSpectrum emission = slope(0.02, 0.05);
    Scene scene = furnace(Room::box, ConstantSpectrum{0.5}, emission);
    std::get<PerspectiveCamera>(scene.camera).fov_deg = 100.0;
    constexpr int kSize_px = 32;
    const PreparedScene prepared(std::move(scene), 1);
    const XYZd once = xyz_of_radiance(emission);

    for (const int wavelengths : {1, 4, 16}) {
        Film film({.width_px = kSize_px, .height_px = kSize_px});
        RenderProgress progress;
        render(prepared, {.samples_per_pixel = 64, .seed = 7, .model = SpectralModel{wavelengths}, .threads = 1}, film,
               progress);
        double sum = 0.0, sum_of_squares = 0.0, count = 0.0;
        const Image<XYZ> picture = film.xyz_image();
        for (const XYZ& pixel : picture.pixels()) {
            const double y = static_cast<double>(pixel.y);
            sum += y;
            sum_of_squares += y * y;
            ++count;
        }
        const double mean = sum / count;
        const double standard_error = std::sqrt((sum_of_squares / count - mean * mean) / (count - 1.0));
        EXPECT_NEAR(mean, 2.0 * once.y, 4.0 * standard_error) << wavelengths << " wavelengths";
        EXPECT_LT(standard_error, 0.01 * mean);
        EXPECT_EQ(progress.samples_done, kSize_px * kSize_px * 64);
    }
}

}  // namespace
}  // namespace emulsion::testing
