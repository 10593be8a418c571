#include "pathtracer/environment_map.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "analytic_scenes.h"
#include "core/random.h"
#include "pathtracer/equal_area.h"
#include "pathtracer/model_channels.h"
#include "pathtracer/scene_transform.h"
#include "support/chi_square.h"

namespace emulsion {
namespace {

using testing::chi_square_test;
using testing::sidak_level;

constexpr double kPi = std::numbers::pi;

/// Chi-square tests of this file, which together raise a false alarm once in a thousand.
constexpr int kTests = 12;
constexpr double kFalseAlarm = 1e-3;

std::array<float, 2> next_2d(Pcg32& random) { return {random.next_float(), random.next_float()}; }

Image<float> weights_of(int width, int height, const std::vector<float>& weights) {
    Image<float> image(width, height);
    std::copy(weights.begin(), weights.end(), image.pixels().begin());
    return image;
}

ImageInfiniteLight light_of(int size, const std::vector<RGB>& texels,
                            const Imath::M44d& world_from_light = Imath::M44d()) {
    auto image = std::make_shared<Image<RGB>>(size, size);
    std::copy(texels.begin(), texels.end(), image->pixels().begin());
    return {image, {ConstantSpectrum{1.0}, 1.0}, world_from_light};
}

/// Some dark, some dim, one black, one bright.
std::vector<RGB> varied_texels() {
    std::vector<RGB> texels;
    for (int i = 0; i < 16; ++i) texels.push_back({0.1f * static_cast<float>(i), 0.3f, 0.02f * static_cast<float>(i)});
    texels[5] = {0, 0, 0};
    texels[10] = {40, 50, 30};
    return texels;
}

// --- The distribution

TEST(TexelDistribution, DensitiesAreThoseOfTheWeights) {
    const TexelDistribution distribution(weights_of(2, 2, {1, 3, 0, 4}));
    EXPECT_FLOAT_EQ(distribution.density(0, 0), 0.5f);
    EXPECT_FLOAT_EQ(distribution.density(1, 0), 1.5f);
    EXPECT_FLOAT_EQ(distribution.density(0, 1), 0.0f);
    EXPECT_FLOAT_EQ(distribution.density(1, 1), 2.0f);
}

TEST(TexelDistribution, WithoutWeightsAllTexelsAreAlike) {
    const TexelDistribution distribution(weights_of(3, 2, {0, 0, 0, 0, 0, 0}));
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 3; ++x) EXPECT_NEAR(distribution.density(x, y), 1.0, 1e-6);
    }
}

TEST(TexelDistribution, EndsOfTheIntervalStayInside) {
    const TexelDistribution distribution(weights_of(3, 3, {0, 1, 0, 0, 0, 0, 0, 2, 0}));
    for (const float u : {0.0f, 0x1p-24f, 0.5f, 0x1.fffffep-1f}) {
        for (const float v : {0.0f, 0x1p-24f, 0.5f, 0x1.fffffep-1f}) {
            const Imath::V2d point = distribution.sample({u, v});
            const auto x = static_cast<int>(point.x * 3), y = static_cast<int>(point.y * 3);
            EXPECT_EQ(x, 1);
            EXPECT_TRUE(y == 0 || y == 2) << point.y;
        }
    }
}

TEST(TexelDistribution, PointsFollowTheDensityEvenWithinTexels) {
    constexpr int kDraws = 400000, kParts = 3;
    const std::vector<Image<float>> cases = {weights_of(4, 4, {1, 2, 0, 5, 0, 0, 0, 0, 3, 3, 3, 3, 9, 1, 1, 100}),
                                             weights_of(1, 3, {1, 7, 2}), weights_of(5, 1, {0, 1e-3f, 1, 0, 1})};
    for (const Image<float>& weights : cases) {
        const TexelDistribution distribution(weights);
        const int columns = weights.width() * kParts, rows = weights.height() * kParts;
        std::vector<double> observed(static_cast<std::size_t>(columns * rows)), expected(observed.size());
        Pcg32 random(3);
        for (int i = 0; i < kDraws; ++i) {
            const Imath::V2d point = distribution.sample(next_2d(random));
            const int x = static_cast<int>(point.x * columns);
            const int y = static_cast<int>(point.y * rows);
            observed[static_cast<std::size_t>(y * columns + x)] += 1.0;
        }
        for (int y = 0; y < rows; ++y) {
            for (int x = 0; x < columns; ++x) {
                const auto density = static_cast<double>(distribution.density(x / kParts, y / kParts));
                expected[static_cast<std::size_t>(y * columns + x)] = kDraws * density / (columns * rows);
            }
        }
        EXPECT_GT(chi_square_test(observed, expected).p_value, sidak_level(kFalseAlarm, kTests));
    }
}

// --- Directions

const Imath::M44d kTurned = rotation(40.0, {1, 2, -1});
const Imath::M44d kMirrored = rotation(110.0, {0.3, -1, 2}) * scaling({-1, 1, 1});

TEST(EnvironmentMap, DirectionsFollowTheDensity) {
    constexpr int kDraws = 400000, kSize = 4, kParts = 3, kBins = kSize * kParts;
    for (const Imath::M44d& world_from_light : {Imath::M44d(), kTurned, kMirrored}) {
        const EnvironmentMap map(light_of(kSize, varied_texels(), world_from_light));
        std::vector<double> observed(kBins * kBins), expected(observed.size());
        Pcg32 random(5);
        for (int i = 0; i < kDraws; ++i) {
            const Imath::V3f direction = map.sample(next_2d(random));
            EXPECT_NEAR(direction.length(), 1.0f, 1e-6f);
            const Imath::V2d place =
                equal_area_place(transform_vector(world_from_light.inverse(), Imath::V3d(direction)).normalized());
            const auto bin = [](double along) { return std::min(static_cast<int>(along * kBins), kBins - 1); };
            observed[static_cast<std::size_t>(bin(place.y) * kBins + bin(place.x))] += 1.0;
        }
        for (int y = 0; y < kBins; ++y) {
            for (int x = 0; x < kBins; ++x) {
                const Imath::V3d direction =
                    transform_vector(world_from_light, equal_area_direction({(x + 0.5) / kBins, (y + 0.5) / kBins}));
                // Equal areas are equal solid angles.
                const double solid_angle = 4.0 * kPi / (kBins * kBins);
                expected[static_cast<std::size_t>(y * kBins + x)] =
                    kDraws * static_cast<double>(map.pdf(Imath::V3f(direction))) * solid_angle;
            }
        }
        EXPECT_GT(chi_square_test(observed, expected).p_value, sidak_level(kFalseAlarm, kTests));
    }
}

TEST(EnvironmentMap, EveryTexelWithLightCanBeDrawn) {
    const EnvironmentMap map(light_of(4, varied_texels()));
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) {
            const Imath::V3f direction(equal_area_direction({(x + 0.5) / 4, (y + 0.5) / 4}));
            const bool black = x == 1 && y == 1;
            EXPECT_EQ(map.pdf(direction) > 0.0f, !black) << x << " " << y;
        }
    }
}

TEST(EnvironmentMap, AnEvenPictureIsDrawnEvenly) {
    const EnvironmentMap map(light_of(3, std::vector<RGB>(9, {0.5f, 0.5f, 0.5f})));
    Pcg32 random(1);
    for (int i = 0; i < 1000; ++i) EXPECT_NEAR(map.pdf(map.sample(next_2d(random))), 0.25 / kPi, 1e-6);
}

TEST(EnvironmentMap, ColoursAreThoseOfTheTexelInTheDirection) {
    const std::vector<RGB> texels = varied_texels();
    const SigmoidTable table(rgb_space("sRGB"));
    for (const Imath::M44d& world_from_light : {Imath::M44d(), kTurned, kMirrored}) {
        EnvironmentMap map(light_of(4, texels, world_from_light));
        map.prepare(rgb_channels("sRGB"), ConstantSpectrum{1.0});
        for (std::size_t i = 0; i < 16; ++i) {
            const std::size_t x = i % 4, y = i / 4;
            const Imath::V2d centre((static_cast<double>(x) + 0.5) / 4, (static_cast<double>(y) + 0.5) / 4);
            const Imath::V3f direction(transform_vector(world_from_light, equal_area_direction(centre)));
            const auto rgb = map.colour(direction, FixedIndex<3>{});
            EXPECT_EQ(rgb[0], texels[i].r);
            EXPECT_EQ(rgb[1], texels[i].g);
            EXPECT_EQ(rgb[2], texels[i].b);
            const ScaledSigmoid expected = table.unbounded(texels[i]);
            const auto values = map.colour(direction, SpectrumTableIndex<4>(testing::kTestWavelengths_nm));
            for (std::size_t k = 0; k < 4; ++k) {
                const auto lambda_nm = static_cast<double>(testing::kTestWavelengths_nm[k]);
                const double sigmoid =
                    expected.scale > 0.0f ? eval(Spectrum(sigmoid_of(expected.sigmoid)), lambda_nm) : 0.0;
                EXPECT_NEAR(values.value[k], static_cast<double>(expected.scale) * sigmoid,
                            1e-4 * static_cast<double>(expected.scale));
            }
        }
    }
}

TEST(EnvironmentMap, ColoursAreThoseOfThePicturesSpace) {
    const RGB texel{0.5f, 2.0f, 0.25f};
    ImageInfiniteLight light = light_of(1, {texel});
    light.space = ColorSpace::rec2020;
    const std::array<float, 4> lambda_nm = {420.0f, 500.0f, 560.5f, 640.0f};
    const SpectrumTableIndex<4> index(lambda_nm);
    const ScaledSigmoid expected = SigmoidTable(rgb_space("Rec2020")).unbounded(texel);
    const SampledSpectrum<4> found = EnvironmentMap(light).colour({0, 0, 1}, index);
    const SampledSpectrum<4> of_sigmoid = eval<4>(expected.sigmoid, lambda_nm);
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(found[i], of_sigmoid[i] * expected.scale, 1e-5f) << i;
    EXPECT_NEAR(mean_luminance(*light.texels, light.space), 0.2627 * 0.5 + 0.6780 * 2.0 + 0.0593 * 0.25, 1e-4);
}

TEST(EnvironmentMap, TheUpperHalfIsTheMiddleOfThePicture) {
    // pbrt-v4's orientation: z up in the middle, x to the right, y down the rows.
    std::vector<RGB> texels(16 * 16, {0, 0, 0});
    texels[8 * 16 + 8] = {1, 0, 0};   // right and below the middle
    texels[8 * 16 + 15] = {0, 1, 0};  // the right edge
    EnvironmentMap map(light_of(16, texels));
    map.prepare(rgb_channels("sRGB"), ConstantSpectrum{1.0});
    EXPECT_EQ(map.colour(Imath::V3f(0.01f, 0.01f, 0.9999f).normalized(), FixedIndex<3>{})[0], 1.0f);
    EXPECT_EQ(map.colour(Imath::V3f(1, 0.001f, 0.001f).normalized(), FixedIndex<3>{})[1], 1.0f);
    EXPECT_EQ(map.colour(Imath::V3f(-0.01f, 0.01f, 0.9999f).normalized(), FixedIndex<3>{})[0], 0.0f);
}

TEST(EnvironmentMap, MeanLuminance) {
    // Luminances of the primaries of sRGB: IEC 61966-2-1.
    const ImageInfiniteLight light = light_of(2, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 2, 2}});
    EXPECT_NEAR(mean_luminance(*light.texels, light.space), (1.0 + 2.0) / 4.0, 1e-6);
    const ImageInfiniteLight green = light_of(1, {{0, 1, 0}});
    EXPECT_NEAR(mean_luminance(*green.texels, green.space), 0.7152, 1e-4);
}

// --- In a scene

/// A floor that looks up at the picture.
Scene floor_under(const ImageInfiniteLight& light, double reflectance) {
    Scene scene;
    scene.materials = {DiffuseMaterial{Spectrum(ConstantSpectrum{reflectance})}};
    Shape floor;
    floor.geometry = testing::parallelogram({-5, -5, 0}, {10, 0, 0}, {0, 10, 0});
    scene.shapes = {floor};
    scene.lights = {light};
    scene.integrator.max_depth = 1;
    return scene;
}

/// The irradiance, on a surface that looks along z of the world, of texels that shine with `radiance`.
double irradiance_of(const Imath::M44d& world_from_light, int size, const std::vector<double>& radiance) {
    constexpr int kParts = 256;
    double sum = 0.0;
    const int steps = size * kParts;
    for (int y = 0; y < steps; ++y) {
        for (int x = 0; x < steps; ++x) {
            const double texel = radiance[static_cast<std::size_t>(y / kParts * size + x / kParts)];
            if (texel == 0.0) continue;
            const Imath::V3d direction =
                transform_vector(world_from_light, equal_area_direction({(x + 0.5) / steps, (y + 0.5) / steps}));
            sum += texel * std::max(direction.z, 0.0);
        }
    }
    return sum * 4.0 * kPi / (static_cast<double>(steps) * steps);
}

void expect_floor_radiance(const Scene& scene, double expected, int count) {
    const auto seen = testing::estimate_radiance(scene, {{0.1f, 0.2f, 1}, {0, 0, -1}}, count);
    for (std::size_t i = 0; i < 4; ++i) {
        // The integral above has an error of 1e-5 and less; greys are exact.
        EXPECT_NEAR(seen.mean[i], expected, 4.0 * seen.standard_error[i] + 2e-5 * expected) << i;
        EXPECT_LT(seen.standard_error[i], 0.01 * expected) << i;
    }
}

TEST(EnvironmentMap, AnEvenPictureLightsAsAnEvenSky) {
    const ImageInfiniteLight light = light_of(4, std::vector<RGB>(16, {0.75f, 0.75f, 0.75f}), kTurned);
    // Seen directly, too.
    const auto sky = testing::estimate_radiance(floor_under(light, 0.5), {{0, 0, 1}, {0, 0.6f, 0.8f}}, 16);
    for (const double radiance : sky.mean) EXPECT_NEAR(radiance, 0.75, 2e-6);
    expect_floor_radiance(floor_under(light, 0.5), 0.5 * 0.75, 20000);
}

TEST(EnvironmentMap, OneBrightTexelLightsAsItsSolidAngle) {
    for (const Imath::M44d& world_from_light : {Imath::M44d(), kTurned, kMirrored}) {
        for (const std::size_t bright : {6u, 9u, 15u}) {
            std::vector<RGB> texels(16, {0, 0, 0});
            std::vector<double> radiance(16, 0.0);
            texels[bright] = {100, 100, 100};
            radiance[bright] = 100.0;
            const double expected = 0.5 / kPi * irradiance_of(world_from_light, 4, radiance);
            if (expected < 0.1) continue;  // below the floor, but for an edge
            expect_floor_radiance(floor_under(light_of(4, texels, world_from_light), 0.5), expected, 40000);
        }
    }
}

TEST(EnvironmentMap, VariedTexelsLightAsTheirSum) {
    std::vector<RGB> texels;
    std::vector<double> radiance;
    for (int i = 0; i < 16; ++i) {
        const double value = i == 10 ? 20.0 : i == 5 ? 0.0 : 0.1 * i;
        radiance.push_back(value);
        const auto grey = static_cast<float>(value);
        texels.push_back({grey, grey, grey});
    }
    const double expected = 0.5 / kPi * irradiance_of(kMirrored, 4, radiance);
    expect_floor_radiance(floor_under(light_of(4, texels, kMirrored), 0.5), expected, 100000);
}

}  // namespace
}  // namespace emulsion
