#include "display/separation.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/named_value.h"
#include "core/random.h"

namespace emulsion {
namespace {

std::vector<BlackGeneration> all_generations() {
    std::vector<BlackGeneration> all;
    for_each_alternative<BlackGeneration>([&](const auto& black) { all.emplace_back(black); });
    for (const double amount : {0.0, 0.3, 1.0}) {
        all.emplace_back(GreyReplacement{amount});
        for (const double start : {0.0, 0.2, 0.999}) all.emplace_back(UnderColorRemoval{amount, start});
    }
    return all;
}

/// Every corner, edge and middle of the cube, all 8-bit greys, and random ones.
std::vector<RGB> colours() {
    std::vector<RGB> all;
    for (const float r : {0.0f, 0.5f, 1.0f}) {
        for (const float g : {0.0f, 0.5f, 1.0f}) {
            for (const float b : {0.0f, 0.5f, 1.0f}) all.push_back({r, g, b});
        }
    }
    for (int i = 0; i <= 255; ++i) {
        const float grey = static_cast<float>(i) / 255.0f;
        all.push_back({grey, grey, grey});
    }
    Pcg32 random(90);
    for (int i = 0; i < 5000; ++i) all.push_back({random.next_float(), random.next_float(), random.next_float()});
    return all;
}

TEST(Separation, RoundTripGivesTheColourBack) {
    for (const BlackGeneration& black : all_generations()) {
        for (const RGB& p : colours()) {
            const Cmyk inks = separate(black, RGBd{p.r, p.g, p.b});
            for (const double ink : {inks.c, inks.m, inks.y, inks.k}) ASSERT_TRUE(ink >= 0.0 && ink <= 1.0) << ink;
            const RGBd back = rgb_from_cmyk(inks);
            ASSERT_NEAR(back.r, p.r, 3e-16) << to_text(black);
            ASSERT_NEAR(back.g, p.g, 3e-16) << to_text(black);
            ASSERT_NEAR(back.b, p.b, 3e-16) << to_text(black);
        }
    }
}

TEST(Separation, PicturesComeBackToSinglePrecision) {
    const std::vector<RGB> picture = colours();
    for (const BlackGeneration& black : all_generations()) {
        std::vector<Inks> inks(picture.size());
        std::vector<RGB> back(picture.size());
        separate(black, picture, inks);
        recombine(inks, back);
        for (std::size_t i = 0; i < picture.size(); ++i) {
            ASSERT_NEAR(back[i].r, picture[i].r, 1.2e-7) << to_text(black);
            ASSERT_NEAR(back[i].g, picture[i].g, 1.2e-7) << to_text(black);
            ASSERT_NEAR(back[i].b, picture[i].b, 1.2e-7) << to_text(black);
            ASSERT_EQ(std::lround(back[i].g * 255.0), std::lround(picture[i].g * 255.0));
        }
    }
}

TEST(Separation, FullReplacementIsTheCmykOfTheColourSystems) {
    for (const RGB& p : colours()) {
        const Cmyk wanted = cmyk_from_rgb({p.r, p.g, p.b}), found = separate(GreyReplacement{}, RGBd{p.r, p.g, p.b});
        ASSERT_NEAR(found.c, wanted.c, 1e-15);
        ASSERT_NEAR(found.m, wanted.m, 1e-15);
        ASSERT_NEAR(found.y, wanted.y, 1e-15);
        ASSERT_NEAR(found.k, wanted.k, 1e-15);
    }
}

TEST(Separation, ByHand) {
    const RGBd color{0.75, 0.5, 0.25};
    EXPECT_EQ(separate(NoBlackInk{}, color), (Cmyk{0.25, 0.5, 0.75, 0.0}));
    EXPECT_EQ(separate(GreyReplacement{}, color).k, 0.25);
    EXPECT_EQ(separate(GreyReplacement{0.5}, color).k, 0.125);
    EXPECT_EQ(separate(UnderColorRemoval{}, color).k, 0.0);
    EXPECT_EQ(separate(UnderColorRemoval{1.0, 0.0}, color), separate(GreyReplacement{}, color));
    EXPECT_EQ(separate(UnderColorRemoval{1.0, 0.5}, RGBd{0.25, 0.25, 0.25}).k, 0.5);
    for (const BlackGeneration black : {BlackGeneration(GreyReplacement{}), BlackGeneration(UnderColorRemoval{})}) {
        EXPECT_EQ(separate(black, RGBd{}), (Cmyk{0.0, 0.0, 0.0, 1.0}));
        EXPECT_EQ(separate(black, RGBd{1.0, 1.0, 1.0}), Cmyk{});
    }
    EXPECT_EQ(separate(UnderColorRemoval{0.8}, RGBd{}), (Cmyk{1.0, 1.0, 1.0, 0.8}));
}

// Of one colour the darker, the more black, and never more than there is grey.
TEST(Separation, BlackGrowsWithDarknessUpToTheGrey) {
    for (const BlackGeneration& black : all_generations()) {
        double before = 0.0;
        for (int i = 0; i <= 1000; ++i) {
            const double light = 1.0 - i / 1000.0, k = separate(black, RGBd{light, 0.5 * light, 0.0}).k;
            EXPECT_GE(k, before);
            EXPECT_LE(k, 1.0 - light + 1e-15);
            before = k;
        }
    }
}

TEST(Separation, WhatIsOutsideIsTakenAsTheNearestInside) {
    const std::vector<RGB> picture{{-1.0f, 2.0f, std::numeric_limits<float>::quiet_NaN()}};
    std::vector<Inks> inks(1);
    separate(NoBlackInk{}, picture, inks);
    EXPECT_EQ(inks[0], (Inks{1.0f, 0.0f, 1.0f, 0.0f}));
}

}  // namespace
}  // namespace emulsion
