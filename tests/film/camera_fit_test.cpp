#include "film/camera_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensor_fixture.h"
#include "spectrum/ciede2000_difference.h"
#include "spectrum/cielab.h"

namespace emulsion {
namespace {

using ::testing::AllOf;
using testing::components;
using ::testing::HasSubstr;
using testing::humps_camera;
using testing::linear_camera;
using testing::product;
using ::testing::ThrowsMessage;

/// Colour of one training surface to the camera and to the target, normalised as the header says.
struct Pair {
    XYZd camera, target;
};

std::vector<Pair> training_pairs(const CameraResponse& response, const Observer& observer,
                                 const CameraTraining& training) {
    const Observer camera = at_whole_nm(response);
    const Spectrum& target = training.target_illuminant ? *training.target_illuminant : training.illuminant;
    const double camera_white = xyz_of_radiance(training.illuminant, observer).y / kLuminousEfficacy;
    std::vector<Pair> all;
    for (const std::string& name : camera_training_names()) {
        const Spectrum reflectance = catalogue_spectrum(name);
        const Spectrum light = product_of(reflectance, training.illuminant);
        all.push_back({(1.0 / camera_white) * integral_with_observer({light}, camera),
                       xyz_of_reflectance(reflectance, target, observer)});
    }
    return all;
}

double squared_error(const std::vector<Pair>& pairs, const Matrix3& matrix) {
    double sum = 0.0;
    for (const auto& [camera, target] : pairs) {
        const auto seen = components(product(matrix, camera)), wanted = components(target);
        for (std::size_t k = 0; k < 3; ++k) sum += (seen[k] - wanted[k]) * (seen[k] - wanted[k]);
    }
    return sum;
}

const Matrix3 kMixed{{{{0.8, 0.3, -0.1}, {-0.2, 1.1, 0.05}, {0.05, -0.1, 0.7}}}};

TEST(CameraFit, TrainsWithTheThreeTables) {
    const auto& names = camera_training_names();
    EXPECT_EQ(names.size(), 24u + 15u + 24u);
    for (const char* name : {"colorchecker-dark-skin", "colorchecker-black", "VS1", "VS15", "ampas-patch125"}) {
        EXPECT_THAT(names, ::testing::Contains(std::string(name)));
    }
}

// Curves that are a linear transform of the observer's functions: the fit is its inverse, and leaves nothing.
TEST(CameraFit, ExactLinearCameraIsRecovered) {
    for (const std::string_view name : observer_names()) {
        for (const Spectrum& illuminant : {Spectrum(DaylightSpectrum{}), Spectrum(BlackbodySpectrum{2856.0}),
                                           Spectrum(catalogue_spectrum("FL11"))}) {
            const CameraResponse camera = linear_camera(observer(name), kMixed);
            const CameraFit fit = fit_camera(camera, observer(name), {illuminant});
            const Matrix3 unit = fit.xyz_from_camera * kMixed;
            for (std::size_t i = 0; i < 3; ++i) {
                for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(unit.m[i][j], i == j ? 1.0 : 0.0, 1e-9) << name;
            }
            EXPECT_LT(fit.max_ciede2000, 1e-9) << name;
        }
    }
}

// And the sensor then is the observer itself, whatever the scale of each curve.
TEST(CameraFit, SensorOfAnExactLinearCameraIsTheObserver) {
    CameraResponse camera = linear_camera(cie_1931_2deg(), kMixed);
    for (RGBd& value : camera.value) value = {1e6 * value.r, 3e-5 * value.g, value.b};
    const Sensor sensor({.camera = CameraSensor{camera, {}}}), eye;
    for (double nm = 360.25; nm < 830.0; nm += 1.25) {
        const auto seen = components(sensor.response(nm)), wanted = components(eye.response(nm));
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(seen[k], wanted[k], 1e-9 * kLuminousEfficacy) << nm;
    }
    ASSERT_TRUE(sensor.camera_fit());
    EXPECT_LT(sensor.camera_fit()->max_ciede2000, 1e-9);
    EXPECT_FALSE(eye.camera_fit());
}

// The least of all squares, by its definition: what is left has nothing in common with any channel, and every other
// matrix leaves more.
TEST(CameraFit, IsTheLeastOfSquares) {
    const CameraTraining trainings[] = {
        {}, {BlackbodySpectrum{2856.0}}, {DaylightSpectrum{4500.0}, DaylightSpectrum{}}};
    for (const CameraTraining& training : trainings) {
        const CameraFit fit = fit_camera(humps_camera(), cie_1931_2deg(), training);
        const std::vector<Pair> pairs = training_pairs(humps_camera(), cie_1931_2deg(), training);
        Matrix3 common;  // of the residuals and the channels; a sum of 63 products of about 1e-2 and 1
        for (const auto& [camera, target] : pairs) {
            const auto c = components(camera), seen = components(product(fit.xyz_from_camera, camera));
            const auto wanted = components(target);
            for (std::size_t i = 0; i < 3; ++i) {
                for (std::size_t j = 0; j < 3; ++j) common.m[i][j] += (seen[i] - wanted[i]) * c[j];
            }
        }
        const double least = squared_error(pairs, fit.xyz_from_camera);
        EXPECT_GT(least, 1e-5);
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                EXPECT_NEAR(common.m[i][j], 0.0, 1e-11);
                for (const double step : {-1e-3, 1e-3}) {
                    Matrix3 other = fit.xyz_from_camera;
                    other.m[i][j] += step;
                    EXPECT_GT(squared_error(pairs, other), least);
                }
            }
        }
    }
}

// The numbers that callers print are those of the colours, one by one.
TEST(CameraFit, ReportsWhatIsLeft) {
    const CameraFit fit = fit_camera(humps_camera(), cie_1931_2deg());
    const XYZd light = xyz_of_radiance(DaylightSpectrum{});
    const XYZd white = (1.0 / light.y) * light;
    const std::vector<Pair> pairs = training_pairs(humps_camera(), cie_1931_2deg(), {});
    double sum = 0.0, largest = 0.0;
    std::string worst;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Lab seen = lab_from_xyz(product(fit.xyz_from_camera, pairs[i].camera), white);
        const double off = difference(Ciede2000Difference{}, lab_from_xyz(pairs[i].target, white), seen);
        sum += off;
        if (off > largest) worst = camera_training_names()[i];
        largest = std::max(largest, off);
    }
    EXPECT_EQ(fit.reflectance_count, 63);
    EXPECT_NEAR(fit.mean_ciede2000, sum / 63.0, 1e-9);
    EXPECT_NEAR(fit.max_ciede2000, largest, 1e-9);
    EXPECT_EQ(fit.worst, worst);
    // Humps aren't the eye: a fit that claims to be better than this hides something.
    EXPECT_GT(fit.mean_ciede2000, 0.1);
    EXPECT_LT(fit.mean_ciede2000, 2.0);
}

// A white surface in the training light has its luminance, as nearly as the fit goes.
TEST(CameraFit, KeepsTheLuminanceOfTheTrainingLight) {
    const Spectrum light = scaled(DaylightSpectrum{}, 0.01);
    const XYZd seen = testing::seen_by(Sensor({.camera = CameraSensor{humps_camera(), {}}}), light);
    const XYZd wanted = xyz_of_radiance(light);
    EXPECT_NEAR(seen.y, wanted.y, 0.02 * wanted.y);
    EXPECT_NEAR(seen.x, wanted.x, 0.02 * wanted.x);
    EXPECT_NEAR(seen.z, wanted.z, 0.02 * wanted.z);
}

// The scale of curves and illuminants doesn't matter.
TEST(CameraFit, DoesNotDependOnScales) {
    const CameraFit fit = fit_camera(humps_camera(), cie_1931_2deg());
    CameraResponse camera = humps_camera();
    for (RGBd& value : camera.value) value = {1e-20 * value.r, 1e15 * value.g, 7.0 * value.b};
    const CameraFit other = fit_camera(camera, cie_1931_2deg(), {scaled(DaylightSpectrum{}, 1e-5), DaylightSpectrum{}});
    const std::array<double, 3> scale = {1e-20, 1e15, 7.0};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const double expected = fit.xyz_from_camera.m[i][j];
            EXPECT_NEAR(other.xyz_from_camera.m[i][j] * scale[j], expected, 1e-11);
        }
    }
    EXPECT_NEAR(other.mean_ciede2000, fit.mean_ciede2000, 1e-9);
}

// Trained from A to D65, as pbrt-v4's whitebalance does it: white under A comes out near D65, and not near A.
TEST(CameraFit, TargetIlluminantBalancesTheWhite) {
    const Spectrum a = BlackbodySpectrum{2856.0}, d65 = DaylightSpectrum{};
    const XYZd seen = testing::seen_by(Sensor({.camera = CameraSensor{humps_camera(), {a, d65}}}), a);
    const Chromaticity got = chromaticity_of(seen), wanted = chromaticity_of(xyz_of_radiance(d65));
    EXPECT_NEAR(got.x, wanted.x, 0.01);
    EXPECT_NEAR(got.y, wanted.y, 0.01);
    EXPECT_NEAR(seen.y, xyz_of_radiance(a).y, 0.02 * seen.y);
}

TEST(CameraFit, RefusesWhatCannotBeSolved) {
    CameraResponse camera = humps_camera();
    for (RGBd& value : camera.value) value.b = 2.0 * value.r - value.g;
    EXPECT_THAT([&] { static_cast<void>(fit_camera(camera, cie_1931_2deg())); },
                ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("camera humps"), HasSubstr("dependent"))));
    // A response where no training surface was measured.
    CameraResponse infrared = humps_camera();
    infrared.lambda_nm = {790.0, 800.0};
    infrared.value = {{1.0, 0.0, 0.0}, {0.0, 1.0, 1.0}};
    EXPECT_THROW(static_cast<void>(fit_camera(infrared, cie_1931_2deg())), std::invalid_argument);
    // A light that the eye doesn't see.
    const CameraTraining dark{PiecewiseLinearSpectrum{{300.0, 350.0}, {1.0, 1.0}}};
    EXPECT_THAT([&] { static_cast<void>(fit_camera(humps_camera(), cie_1931_2deg(), dark)); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("ybar is 0")));
}

}  // namespace
}  // namespace emulsion
