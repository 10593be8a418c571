#include "spectrum/color_difference.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "core/text_file.h"
#include "spectrum/data_table.h"

namespace emulsion {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Lab random_lab(Pcg32& random) {
    const auto unit = [&] { return static_cast<double>(random.next_float()); };
    return {100.0 * unit(), 200.0 * unit() - 100.0, 200.0 * unit() - 100.0};
}

Lab polar(double lightness, double chroma, double hue_degrees) {
    const double angle = hue_degrees * std::acos(-1.0) / 180.0;
    return {lightness, chroma * std::cos(angle), chroma * std::sin(angle)};
}

TEST(ColorDifference, IsZeroForEqualColoursAndPositiveForOthers) {
    for_each_alternative<ColorDifference>([](const auto& method) {
        SCOPED_TRACE(method.kName);
        Pcg32 random(80);
        EXPECT_EQ(difference(method, Lab{}, Lab{}), 0.0);
        for (int i = 0; i < 2000; ++i) {
            const Lab a = random_lab(random), b = random_lab(random);
            EXPECT_EQ(difference(method, a, a), 0.0);
            EXPECT_GT(difference(method, a, b), 0.0);
        }
    });
}

TEST(ColorDifference, OfNaNIsNaN) {
    for_each_alternative<ColorDifference>([](const auto& method) {
        SCOPED_TRACE(method.kName);
        const Lab fine = {50.0, 10.0, -20.0};
        for (const Lab& bad : {Lab{kNaN, 10.0, -20.0}, Lab{50.0, kNaN, -20.0}, Lab{50.0, 10.0, kNaN}}) {
            EXPECT_TRUE(std::isnan(difference(method, fine, bad)));
            EXPECT_TRUE(std::isnan(difference(method, bad, fine)));
        }
    });
}

// Near a colour every difference is a norm: half the step, half the difference.
TEST(ColorDifference, IsProportionalForSmallSteps) {
    for_each_alternative<ColorDifference>([](const auto& method) {
        SCOPED_TRACE(method.kName);
        Pcg32 random(81);
        for (int i = 0; i < 500; ++i) {
            const Lab a = random_lab(random), d = random_lab(random);
            const auto stepped = [&](double s) { return Lab{a.l + s * d.l, a.a + s * d.a, a.b + s * d.b}; };
            const double ratio = difference(method, a, stepped(2e-6)) / difference(method, a, stepped(1e-6));
            EXPECT_NEAR(ratio, 2.0, 1e-4) << a.l << ' ' << a.a << ' ' << a.b;
        }
    });
}

template <class Method>
double largest_asymmetry(const Method& method) {
    Pcg32 random(82);
    double largest = 0.0;
    for (int i = 0; i < 2000; ++i) {
        const Lab a = random_lab(random), b = random_lab(random);
        const double there = difference(method, a, b), back = difference(method, b, a);
        largest = std::max(largest, std::abs(there / back - 1.0));
    }
    return largest;
}

TEST(ColorDifference, IsSymmetricOrSaysThatItIsNot) {
    EXPECT_EQ(largest_asymmetry(Cie76Difference{}), 0.0);
    EXPECT_LT(largest_asymmetry(Ciede2000Difference{}), 1e-14);
    EXPECT_GT(largest_asymmetry(Cie94GraphicDifference{}), 0.5);
    EXPECT_GT(largest_asymmetry(Cie94TextileDifference{}), 0.5);
    EXPECT_GT(largest_asymmetry(CmcDifference{}), 0.5);
}

TEST(ColorDifference, DefaultIsCiede2000AndTextHasItsParameters) {
    EXPECT_EQ(to_text(ColorDifference{}), "ciede2000");
    EXPECT_EQ(parse_named<ColorDifference>("cmc:l=1", "difference"), ColorDifference{(CmcDifference{1.0, 1.0})});
    EXPECT_THROW((void)parse_named<ColorDifference>("cmc:c=0", "difference"), std::invalid_argument);
}

TEST(Cie76Difference, IsEuclidean) {
    EXPECT_DOUBLE_EQ(difference(Cie76Difference{}, Lab{50.0, 1.0, 2.0}, Lab{53.0, 5.0, 14.0}), 13.0);
}

// Two greys differ in lightness only: the closed forms of each.
TEST(ColorDifference, OfGreys) {
    const Lab dark = {40.0, 0.0, 0.0}, light = {60.0, 0.0, 0.0};
    EXPECT_DOUBLE_EQ(difference(Cie94GraphicDifference{}, dark, light), 20.0);
    EXPECT_DOUBLE_EQ(difference(Cie94TextileDifference{}, dark, light), 10.0);
    EXPECT_DOUBLE_EQ(difference(CmcDifference{}, dark, light), 10.0 * (1.0 + 0.01765 * 40.0) / (0.040975 * 40.0));
    EXPECT_DOUBLE_EQ(difference(CmcDifference{1.0, 1.0}, {10.0, 0.0, 0.0}, {12.0, 0.0, 0.0}), 2.0 / 0.511);
    EXPECT_DOUBLE_EQ(difference(Ciede2000Difference{}, dark, light), 20.0);  // mean L* of 50
    const double sl = 1.0 + 0.015 * 400.0 / std::sqrt(20.0 + 400.0);
    EXPECT_DOUBLE_EQ(difference(Ciede2000Difference{}, {60.0, 0.0, 0.0}, {80.0, 0.0, 0.0}), 20.0 / sl);
}

// From grey there is a difference in chroma but none in hue, so that all hues are equally far.
TEST(ColorDifference, FromGreyIsOfChromaAlone) {
    const Lab grey = {50.0, 0.0, 0.0};
    for (double hue = 0.0; hue < 360.0; hue += 7.0) {
        const Lab colour = polar(50.0, 20.0, hue);
        EXPECT_NEAR(difference(Cie94GraphicDifference{}, grey, colour), 20.0, 1e-12) << hue;
        EXPECT_NEAR(difference(Cie94GraphicDifference{}, colour, grey), 20.0 / (1.0 + 0.045 * 20.0), 1e-12) << hue;
        EXPECT_NEAR(difference(CmcDifference{}, grey, colour), 20.0 / 0.638, 1e-12) << hue;
    }
}

// colour-science's tests, all with one reference; l is of no matter, the lightnesses being equal. The third CIEDE2000
// is the one where a mean hue of 361 degrees is not the same as 1: Lindbloom's formula, and colour-science in older
// versions, have 68.23094879 there.
TEST(ColorDifference, AgreesWithColourScience) {
    const Lab reference = {100.0, 21.57210357, 272.22819350};
    const Lab samples[] = {
        {100.0, 426.67945353, 72.39590835}, {100.0, 74.05216981, 276.45318193}, {100.0, 8.32281957, -73.58297716}};
    const double graphic[] = {83.779225500887094, 10.053931954553839, 57.535453706667425};
    const double textile[] = {88.335553057506502, 10.612657890048272, 60.368687261063329};
    const double cmc[] = {172.70477129, 20.59732717, 121.71841479};
    const double ciede2000[] = {94.03564903, 14.87906419, 68.23111251};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(difference(Cie94GraphicDifference{}, reference, samples[i]), graphic[i], 1e-12);
        EXPECT_NEAR(difference(Cie94TextileDifference{}, reference, samples[i]), textile[i], 1e-12);
        EXPECT_NEAR(difference(CmcDifference{}, reference, samples[i]), cmc[i], 6e-9);
        EXPECT_NEAR(difference(Ciede2000Difference{}, reference, samples[i]), ciede2000[i], 6e-9);
    }
}

// python-colormath's tests, checked there against Lindbloom's calculator, to three decimals.
TEST(ColorDifference, AgreesWithColormath) {
    const Lab reference = {0.9, 16.3, -2.22}, sample = {0.7, 14.2, -1.80};
    EXPECT_NEAR(difference(Cie76Difference{}, reference, sample), 2.151, 5e-4);
    EXPECT_NEAR(difference(Cie94GraphicDifference{}, reference, sample), 1.249, 5e-4);
    EXPECT_NEAR(difference(Cie94TextileDifference{}, reference, sample), 1.204, 5e-4);
    EXPECT_NEAR(difference(CmcDifference{}, reference, sample), 1.443, 5e-4);
    EXPECT_NEAR(difference(CmcDifference{1.0, 1.0}, reference, sample), 1.482, 5e-4);
    EXPECT_NEAR(difference(Ciede2000Difference{}, reference, sample), 1.523, 5e-4);
    EXPECT_NEAR(difference(CmcDifference{}, {69.417, -12.612, -11.271}, {83.386, 39.426, -17.525}), 44.346, 5e-4);
}

// The steps that the header documents: lightness at 16, hue at 164 and 345 degrees.
TEST(CmcDifference, StepsAtItsRoundedJoins) {
    const auto of_lightness = [](double l) { return difference(CmcDifference{1.0, 1.0}, {l, 0, 0}, {l + 1.0, 0, 0}); };
    EXPECT_NEAR(of_lightness(16.0 - 1e-9), 1.0 / 0.511, 1e-8);
    EXPECT_NEAR(of_lightness(16.0), 1.0 / (0.511 + 2.289457e-4), 1e-9);

    // A hue alone that differs by little: dE = dH / SH, SH = SC (F T + 1 - F).
    constexpr double kChroma = 40.0, kTurn = 1e-6;
    const double sc = 0.0638 * kChroma / (1.0 + 0.0131 * kChroma) + 0.638;
    const double f = 1600.0 / std::sqrt(1600.0 * 1600.0 + 1900.0);
    const auto t = [&](double hue) {
        const Lab reference = polar(50.0, kChroma, hue), sample = polar(50.0, kChroma, hue + kTurn);
        const double dh = difference(Cie76Difference{}, reference, sample);
        return (dh / difference(CmcDifference{}, reference, sample) / sc - 1.0 + f) / f;
    };
    EXPECT_NEAR(t(164.0 - 1e-6), 0.7382074, 1e-6);
    EXPECT_NEAR(t(164.0 + 1e-6), 0.7365895, 1e-6);
    EXPECT_NEAR(t(345.0 - 1e-6), 0.7382013, 1e-6);
    EXPECT_NEAR(t(345.0 + 1e-6), 0.7358770, 1e-6);
    EXPECT_NEAR(t(179.999999), t(180.000001), 1e-6);
}

TEST(Ciede2000Difference, HasThePublishedValuesOfAll34Pairs) {
    const DataTable pairs =
        parse_data_table("sharma_ciede2000_pairs",
                         read_text_file(std::string(EMULSION_SOURCE_DIR) + "/tests/data/sharma_ciede2000_pairs.csv"));
    ASSERT_EQ(pairs.row_count(), 34u);
    for (std::size_t i = 0; i < pairs.row_count(); ++i) {
        const auto value = [&](const char* column) { return pairs.column(column)[i]; };
        const Lab first = {value("L1"), value("a1"), value("b1")}, second = {value("L2"), value("a2"), value("b2")};
        const double there = difference(Ciede2000Difference{}, first, second);
        const double back = difference(Ciede2000Difference{}, second, first);
        EXPECT_DOUBLE_EQ(there, back) << i + 1;
        const bool either = i + 1 == 14 && std::abs(there - 4.7461) <= 0.5e-4;
        if (!either) {
            EXPECT_NEAR(there, value("dE00"), 0.5e-4) << i + 1;
        }
    }
}

// Opposite hues: the mean hue jumps by 180 degrees, the difference by about 1 % in pair 14's case.
TEST(Ciede2000Difference, JumpsWhereHuesAreOpposite) {
    const Lab reference = polar(50.0, 2.49, 90.0);
    const double before = difference(Ciede2000Difference{}, reference, polar(50.0, 2.49, 270.0 - 1e-6));
    const double after = difference(Ciede2000Difference{}, reference, polar(50.0, 2.49, 270.0 + 1e-6));
    EXPECT_NEAR(before / after, 4.8045 / 4.7461, 5e-4);
    // Exactly opposite, along the axes, where no rounding enters: half the sum, 180 and 90 degrees.
    const auto at = [](double a, double b) { return Lab{50.0, a, b}; };
    EXPECT_NEAR(difference(Ciede2000Difference{}, at(0, 2.49), at(0, -2.49)), before, 1e-6);
    EXPECT_EQ(difference(Ciede2000Difference{}, at(0, 2.49), at(0, -2.49)),
              difference(Ciede2000Difference{}, at(0, -2.49), at(0, 2.49)));
    EXPECT_EQ(difference(Ciede2000Difference{}, at(2.49, 0), at(-2.49, 0)),
              difference(Ciede2000Difference{}, at(-2.49, 0), at(2.49, 0)));
}

// The hue circle is closed: nothing happens where the angle goes from 360 to 0.
TEST(Ciede2000Difference, IsContinuousAcrossHueZero) {
    for (const double other : {20.0, 90.0, 200.0, 340.0}) {
        const Lab sample = polar(55.0, 30.0, other);
        const double below = difference(Ciede2000Difference{}, polar(50.0, 40.0, -1e-9), sample);
        const double above = difference(Ciede2000Difference{}, polar(50.0, 40.0, 1e-9), sample);
        EXPECT_NEAR(below, above, 1e-8) << other;
    }
}

}  // namespace
}  // namespace emulsion
