#include "pathtracer/texture_lookup.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "pathtracer/scene_transform.h"
#include "pathtracer/texture_mapping.h"

namespace emulsion {
namespace {

// --- Mappings

void expect_mapped(const TextureMapping& mapping, const TexturePoint& point, double s, double t) {
    const Imath::V2d st = map(mapping, point);
    EXPECT_NEAR(st.x, s, 1e-12);
    EXPECT_NEAR(st.y, t, 1e-12);
}

TEST(TextureMapping, UvIsScaledAndMoved) {
    expect_mapped(UvMapping{}, {{9, 9, 9}, {0.25f, 0.75f}}, 0.25, 0.75);
    expect_mapped(UvMapping{2, -4, 0.5, 1}, {{9, 9, 9}, {0.25f, 0.75f}}, 1.0, -2.0);
}

TEST(TextureMapping, SphericalIsThetaAndPhi) {
    const SphericalTextureMapping mapping{Imath::M44d()};
    expect_mapped(mapping, {{0, 0, 3}, {}}, 0.0, 0.0);
    expect_mapped(mapping, {{5, 0, 0}, {}}, 0.5, 0.0);
    expect_mapped(mapping, {{0, 5, 0}, {}}, 0.5, 0.25);
    expect_mapped(mapping, {{-1, 0, -1}, {}}, 0.75, 0.5);
    expect_mapped(mapping, {{0, -1, 1}, {}}, 0.25, 0.75);
    expect_mapped(mapping, {{0, 0, -2}, {}}, 1.0, 0.0);
    expect_mapped(mapping, {{0, 0, 0}, {}}, 0.0, 0.0);
}

TEST(TextureMapping, CylindricalIsPhiAndHeight) {
    const CylindricalTextureMapping mapping{Imath::M44d()};
    expect_mapped(mapping, {{2, 0, 0.25f}, {}}, 0.5, 0.25);
    expect_mapped(mapping, {{0, 2, -7}, {}}, 0.75, -7.0);
    expect_mapped(mapping, {{0, -2, 0}, {}}, 0.25, 0.0);
}

TEST(TextureMapping, PlanarIsAlongTwoVectors) {
    expect_mapped(PlanarTextureMapping{Imath::M44d()}, {{2, 3, 4}, {}}, 2.0, 3.0);
    expect_mapped(PlanarTextureMapping{Imath::M44d(), {0, 0, 2}, {1, 1, 0}, 0.5, -1}, {{2, 3, 4}, {}}, 8.5, 4.0);
}

TEST(TextureMapping, PointsAreTakenToTextureSpace) {
    // Texture space is turned by a quarter about z and lies at (10, 0, 0) in the world.
    const Imath::M44d world_from_texture = rotation(90.0, {0, 0, 1}) * translation({10, 0, 0});
    const Imath::M44d texture_from_world = inverse_of(world_from_texture).value();
    // (10, 1, 0) is (1, 0, 0) there.
    expect_mapped(PlanarTextureMapping{texture_from_world}, {{10, 1, 0}, {}}, 1.0, 0.0);
    expect_mapped(CylindricalTextureMapping{texture_from_world}, {{10, 1, 3}, {}}, 0.5, 3.0);
    expect_mapped(SphericalTextureMapping{texture_from_world}, {{10, 1, 0}, {}}, 0.5, 0.0);
}

// --- Images

/// 1 2 3
/// 4 5 6
Image<float> numbered_image() {
    Image<float> image(3, 2);
    for (int i = 0; i < 6; ++i) image.pixels()[static_cast<std::size_t>(i)] = static_cast<float>(i + 1);
    return image;
}

float nearest(TextureWrap wrap, double s, double t) {
    return lookup(numbered_image(), wrap, TextureFilter::nearest, {s, t});
}
float bilinear(TextureWrap wrap, double s, double t) {
    return lookup(numbered_image(), wrap, TextureFilter::bilinear, {s, t});
}

TEST(TextureLookup, NearestTakesTheTexelThatThePlaceLiesIn) {
    const TextureWrap any = TextureWrap::repeat;
    EXPECT_EQ(nearest(any, 0.01, 0.99), 1.0f);  // t counts from the bottom
    EXPECT_EQ(nearest(any, 0.34, 0.51), 2.0f);
    EXPECT_EQ(nearest(any, 0.99, 0.01), 6.0f);
    EXPECT_EQ(nearest(any, 0.32, 0.49), 4.0f);
}

TEST(TextureLookup, WrapModesGoOnBeyondTheBorders) {
    // Two texels to the left of the first, and one row above.
    const double left = -1.5 / 3, above = 1.25;
    EXPECT_EQ(nearest(TextureWrap::repeat, left, 0.75), 2.0f);
    EXPECT_EQ(nearest(TextureWrap::repeat, left - 7, 0.75 + 4), 2.0f);
    EXPECT_EQ(nearest(TextureWrap::repeat, 0.1, above), 4.0f);
    EXPECT_EQ(nearest(TextureWrap::clamp, left, 0.75), 1.0f);
    EXPECT_EQ(nearest(TextureWrap::clamp, 1e30, -1e30), 6.0f);
    EXPECT_EQ(nearest(TextureWrap::clamp, 0.5, above), 2.0f);
    EXPECT_EQ(nearest(TextureWrap::black, left, 0.75), 0.0f);
    EXPECT_EQ(nearest(TextureWrap::black, 0.5, above), 0.0f);
    EXPECT_EQ(nearest(TextureWrap::black, 1e300, 0.5), 0.0f);
    EXPECT_EQ(nearest(TextureWrap::black, 0.5, 0.75), 2.0f);
}

TEST(TextureLookup, BilinearIsExactAtCentresAndLinearBetween) {
    const TextureWrap any = TextureWrap::clamp;
    EXPECT_FLOAT_EQ(bilinear(any, 0.5 / 3, 0.75), 1.0f);
    EXPECT_FLOAT_EQ(bilinear(any, 2.5 / 3, 0.25), 6.0f);
    EXPECT_FLOAT_EQ(bilinear(any, 1.0 / 3, 0.75), 1.5f);
    EXPECT_FLOAT_EQ(bilinear(any, 0.5 / 3, 0.5), 2.5f);
    // A quarter from column 1 to 2, three quarters from row 0 to 1: the values are x + 3 y + 1.
    EXPECT_FLOAT_EQ(bilinear(any, (1.5 + 0.25) / 3, 1.0 - (0.5 + 0.75) / 2), 1.0f + 1.25f + 3 * 0.75f);
}

TEST(TextureLookup, TheBellIsThatOfEllipsesWithoutFootprint) {
    const auto bell = [](double s, double t) {
        return lookup(numbered_image(), TextureWrap::clamp, TextureFilter::gaussian, Imath::V2d(s, t));
    };
    EXPECT_FLOAT_EQ(bell(0.5 / 3, 0.75), 1.0f);
    EXPECT_FLOAT_EQ(bell(1.0 / 3, 0.75), 1.5f);
    EXPECT_FLOAT_EQ(bell(1.0 / 3, 0.5), 3.0f);
    // A quarter of a texel to the right of the first: nearer to it than straight lines are.
    const double near = std::exp(-2.0 / 16) - std::exp(-2.0), far = std::exp(-2.0 * 9 / 16) - std::exp(-2.0);
    EXPECT_NEAR(bell(0.75 / 3, 0.75), 1.0 + far / (near + far), 1e-6);
    // Towards the middle of four, with the two of the other row: one of them is too far away.
    const double x = 0.25, y = 0.125;
    const auto weight = [](double dx, double dy) {
        return std::max(0.0, std::exp(-2.0 * (dx * dx + dy * dy)) - std::exp(-2.0));
    };
    const double w[] = {weight(x, y), weight(1 - x, y), weight(x, 1 - y), weight(1 - x, 1 - y)};
    EXPECT_EQ(w[3], 0.0);
    EXPECT_NEAR(bell((0.5 + x) / 3, 1.0 - (0.5 + y) / 2), (1.0 * w[0] + 2.0 * w[1] + 4.0 * w[2]) / (w[0] + w[1] + w[2]),
                1e-6);
}

TEST(TextureLookup, BilinearMixesWithWhatLiesBeyondTheBorder) {
    // In the middle of the left edge of the upper row.
    EXPECT_FLOAT_EQ(bilinear(TextureWrap::repeat, 0.0, 0.75), 2.0f);  // 1 and 3
    EXPECT_FLOAT_EQ(bilinear(TextureWrap::clamp, 0.0, 0.75), 1.0f);
    EXPECT_FLOAT_EQ(bilinear(TextureWrap::black, 0.0, 0.75), 0.5f);
    // In the left upper corner: 1, its neighbours to the left (3), above (4) and both (6).
    EXPECT_FLOAT_EQ(bilinear(TextureWrap::repeat, 0.0, 1.0), 3.5f);
    EXPECT_FLOAT_EQ(bilinear(TextureWrap::black, 0.0, 1.0), 0.25f);
}

TEST(TextureLookup, OctahedralImagesGoOnTurnedHalfRound) {
    // Right of the last column is the same column upside down; below the last row the same row backwards.
    EXPECT_EQ(wrapped_texel(numbered_image(), TextureWrap::octahedral_sphere, 3, 0), 6.0f);
    EXPECT_EQ(wrapped_texel(numbered_image(), TextureWrap::octahedral_sphere, 0, 2), 6.0f);
    EXPECT_EQ(wrapped_texel(numbered_image(), TextureWrap::octahedral_sphere, 2, 2), 4.0f);
    EXPECT_EQ(wrapped_texel(numbered_image(), TextureWrap::octahedral_sphere, 1, 1), 5.0f);
    // As pbrt-v4 has it: one column further in, at the left.
    EXPECT_EQ(wrapped_texel(numbered_image(), TextureWrap::octahedral_sphere, -1, 0), 5.0f);
    EXPECT_FLOAT_EQ(bilinear(TextureWrap::octahedral_sphere, 1.0, 0.75), 4.5f);  // 3 and 6
}

TEST(TextureLookup, TakesAnyNumbers) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const TextureWrap wrap :
         {TextureWrap::repeat, TextureWrap::black, TextureWrap::clamp, TextureWrap::octahedral_sphere}) {
        for (const double s : {0.0, -0.0, 1.0, -1.0, 2.0, 1e300, -1e300, -1e-300, kInfinity, -kInfinity,
                               std::numeric_limits<double>::quiet_NaN(), 0x1.fffffffffffffp-1}) {
            for (const double t : {0.3, s}) {
                for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear}) {
                    const float value = lookup(numbered_image(), wrap, filter, {s, t});
                    EXPECT_GE(value, 0.0f);
                    EXPECT_LE(value, 6.0f);
                }
            }
        }
    }
}

TEST(TextureLookup, ASingleTexelIsEverywhere) {
    Image<float> image(1, 1);
    image(0, 0) = 7.0f;
    for (const TextureWrap wrap : {TextureWrap::repeat, TextureWrap::clamp, TextureWrap::octahedral_sphere}) {
        EXPECT_EQ(lookup(image, wrap, TextureFilter::bilinear, {0.0, 1.0}), 7.0f);
        EXPECT_EQ(lookup(image, wrap, TextureFilter::nearest, {1.0, 0.0}), 7.0f);
    }
}

}  // namespace
}  // namespace emulsion
