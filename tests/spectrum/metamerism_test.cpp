#include "spectrum/metamerism.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/matrix3.h"
#include "core/random.h"
#include "spectrum/colorimetry.h"
#include "spectrum/data_table.h"

namespace emulsion {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr const char* kIlluminants = "illuminants_a_d_300_830_5nm";

LightAndObserver under(const char* illuminant) { return {tabulated_spectrum(kIlluminants, illuminant)}; }

constexpr double kFirst_nm = 400.0, kStep_nm = 10.0;
constexpr std::size_t kKnots = 31;

PiecewiseLinearSpectrum reflectance(const std::vector<double>& value) {
    PiecewiseLinearSpectrum spectrum;
    for (std::size_t i = 0; i < value.size(); ++i) {
        spectrum.lambda_nm.push_back(kFirst_nm + kStep_nm * static_cast<double>(i));
    }
    spectrum.value = value;
    return spectrum;
}

// XYZ of the reflectances that are 1 at one knot and 0 at the others: XYZ of any other is their sum.
std::vector<XYZd> basis(const LightAndObserver& conditions) {
    std::vector<XYZd> xyz;
    for (std::size_t i = 0; i < kKnots; ++i) {
        std::vector<double> value(kKnots, 0.0);
        value[i] = 1.0;
        xyz.push_back(xyz_of_reflectance(reflectance(value), conditions.illuminant, conditions.observer));
    }
    return xyz;
}

// A random direction without its part in the space of the three rows of `basis`: what the observer can't see.
std::vector<double> metameric_black(const std::vector<XYZd>& basis, Pcg32& random) {
    std::vector<std::array<double, 3>> column;
    for (const XYZd& xyz : basis) column.push_back({xyz.x, xyz.y, xyz.z});
    std::vector<double> black(basis.size());
    for (double& value : black) value = random.next_float() - 0.5;

    // Twice, as the first time leaves rounding errors.
    for (int pass = 0; pass < 2; ++pass) {
        Matrix3 gram;
        std::array<double, 3> seen{};
        for (std::size_t k = 0; k < basis.size(); ++k) {
            for (std::size_t i = 0; i < 3; ++i) {
                seen[i] += column[k][i] * black[k];
                for (std::size_t j = 0; j < 3; ++j) gram.m[i][j] += column[k][i] * column[k][j];
            }
        }
        const std::array<double, 3> weight = inverse(gram) * seen;
        for (std::size_t k = 0; k < basis.size(); ++k) {
            for (std::size_t i = 0; i < 3; ++i) black[k] -= column[k][i] * weight[i];
        }
    }
    return black;
}

// A smooth reflectance, and another that looks the same under the conditions.
struct Metamers {
    PiecewiseLinearSpectrum a, b;
};

Metamers metamers(const LightAndObserver& conditions, std::uint64_t seed) {
    Pcg32 random(seed);
    const std::vector<double> black = metameric_black(basis(conditions), random);
    std::vector<double> a(kKnots), b(kKnots);
    for (std::size_t k = 0; k < kKnots; ++k) {
        a[k] = 0.5 + 0.2 * std::sin(0.2 * static_cast<double>(k));
        b[k] = a[k] + 0.25 * black[k];
    }
    return {reflectance(a), reflectance(b)};
}

TEST(Metamers, LookTheSameUnderOneLightAndDriftUnderAnother) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const auto [a, b] = metamers(under("D65"), seed);
        const XYZd apart = xyz_difference(a, b, under("D65"));
        EXPECT_NEAR(apart.x, 0.0, 1e-14);
        EXPECT_NEAR(apart.y, 0.0, 1e-14);
        EXPECT_NEAR(apart.z, 0.0, 1e-14);
        EXPECT_TRUE(are_metameric(a, b, under("D65"), XyzTolerance{1e-9}));
        EXPECT_FALSE(are_metameric(a, b, under("A"), XyzTolerance{1e-4}));
    }
}

TEST(Metamers, DriftByEveryColourDifference) {
    const auto [a, b] = metamers(under("D65"), 1);
    for_each_alternative<ColorDifference>([&, &a = a, &b = b]<class Method>(const Method& method) {
        EXPECT_LT(lab_difference(a, b, under("D65"), method), 1e-9) << Method::kName;
        EXPECT_GT(lab_difference(a, b, under("A"), method), 0.1) << Method::kName;
        EXPECT_TRUE(are_metameric(a, b, under("D65"), LabTolerance{method, 1e-9})) << Method::kName;
        EXPECT_FALSE(are_metameric(a, b, under("A"), LabTolerance{method, 0.1})) << Method::kName;

        const MetamerismIndex index = metamerism_index(a, b, under("D65"), under("A"), method);
        EXPECT_LT(index.reference_difference, 1e-9) << Method::kName;
        EXPECT_NEAR(index.index, lab_difference(a, b, under("A"), method), 1e-9) << Method::kName;
        EXPECT_EQ(metamerism_index(a, a, under("D65"), under("A"), method).index, 0.0) << Method::kName;
    });
}

TEST(Metamers, DriftUnderAnotherObserverToo) {
    const DataTable& table = data_table("cie_1964_10deg_xyz_1nm");
    LightAndObserver large_field = under("D65");
    large_field.observer = {"CIE 1964", 360, {}};
    for (std::size_t i = 0; i < table.row_count(); ++i) {
        large_field.observer.value.push_back({table.columns[1][i], table.columns[2][i], table.columns[3][i]});
    }
    const auto [a, b] = metamers(under("D65"), 1);
    EXPECT_GT(metamerism_index(a, b, under("D65"), large_field, Cie76Difference{}).index, 0.1);
    const auto [c, d] = metamers(large_field, 1);
    EXPECT_TRUE(are_metameric(c, d, large_field, XyzTolerance{1e-13}));
    EXPECT_FALSE(are_metameric(c, d, under("D65"), XyzTolerance{1e-4}));
}

TEST(MetamerismIndex, OfEqualReflectancesIsZero) {
    const auto [a, b] = metamers(under("D65"), 3);
    const MetamerismIndex same = metamerism_index(a, a, under("D65"), under("A"), Cie76Difference{});
    EXPECT_EQ(same.index, 0.0);
    EXPECT_EQ(same.reference_difference, 0.0);
    const MetamerismIndex black =
        metamerism_index(ConstantSpectrum{0.0}, ConstantSpectrum{0.0}, under("D65"), under("A"), Cie76Difference{});
    EXPECT_EQ(black.index, 0.0);
    // Greys of different lightness match nowhere, but no light drives them apart: the correction takes it all.
    const MetamerismIndex greys =
        metamerism_index(ConstantSpectrum{0.4}, ConstantSpectrum{0.5}, under("D65"), under("A"), Cie76Difference{});
    EXPECT_GT(greys.reference_difference, 5.0);
    EXPECT_NEAR(greys.index, 0.0, 1e-11);
}

TEST(MetamerismIndex, CorrectsAFactorExactly) {
    // b made 2% lighter at all wavelengths: X, Y and Z grow by 2% everywhere, and the correction undoes that.
    const auto [a, b] = metamers(under("D65"), 4);
    PiecewiseLinearSpectrum lighter = b;
    for (double& value : lighter.value) value *= 1.02;
    const MetamerismIndex exact = metamerism_index(a, b, under("D65"), under("A"), Cie76Difference{}),
                          corrected = metamerism_index(a, lighter, under("D65"), under("A"), Cie76Difference{});
    EXPECT_GT(corrected.reference_difference, 0.5);
    EXPECT_NEAR(corrected.index, exact.index, 1e-10);
}

TEST(MetamerismIndex, GrowsWithTheBlackPart) {
    const auto [a, b] = metamers(under("D65"), 2);
    double last = 0.0;
    for (const double amount : {0.25, 0.5, 1.0}) {
        PiecewiseLinearSpectrum part = a;
        for (std::size_t k = 0; k < kKnots; ++k) part.value[k] += amount * (b.value[k] - a.value[k]);
        const double index = metamerism_index(a, part, under("D65"), under("A"), Cie76Difference{}).index;
        EXPECT_GT(index, 1.8 * last) << "about in proportion";
        last = index;
    }
}

TEST(Metamerism, RefusesBadInput) {
    const ConstantSpectrum grey{0.5};
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT([&] { (void)are_metameric(grey, grey, under("D65"), XyzTolerance{-1.0}); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("largest = -1")));
    EXPECT_THROW((void)are_metameric(grey, grey, under("D65"), LabTolerance{Cie76Difference{}, kNaN}),
                 std::invalid_argument);
    EXPECT_THAT(
        [&] { (void)metamerism_index(grey, ConstantSpectrum{0.0}, under("D65"), under("A"), Cie76Difference{}); },
        ThrowsMessage<std::invalid_argument>(HasSubstr("X = 0 of b")));
    EXPECT_THROW((void)xyz_difference(grey, grey, {ConstantSpectrum{0.0}}), std::invalid_argument);
    EXPECT_THROW((void)xyz_difference(grey, ConstantSpectrum{kNaN}, under("D65")), std::invalid_argument);
}

}  // namespace
}  // namespace emulsion
