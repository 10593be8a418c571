#include "spectrum/chromatic_adaptation.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace emulsion {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

// ASTM E308, the whites that Lindbloom's matrices are for.
constexpr XYZd kA = {1.09850, 1.0, 0.35585};
constexpr XYZd kD50 = {0.96422, 1.0, 0.82521};
constexpr XYZd kD65 = {0.95047, 1.0, 1.08883};
constexpr XYZd kE = {1.0, 1.0, 1.0};
constexpr XYZd kDimD75 = {0.2 * 0.94972, 0.2, 0.2 * 1.22638};
constexpr std::array kWhites = {kA, kD50, kD65, kE, kDimD75};

constexpr Matrix3 kIdentity = {{{{{1.0, 0.0, 0.0}}, {{0.0, 1.0, 0.0}}, {{0.0, 0.0, 1.0}}}}};

void expect_near(const Matrix3& got, const Matrix3& wanted, double tolerance) {
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(got.m[i][j], wanted.m[i][j], tolerance) << i << ", " << j;
    }
}

std::array<double, 3> triple(const XYZd& xyz) { return {xyz.x, xyz.y, xyz.z}; }

TEST(ChromaticAdaptation, CompleteTakesWhiteToWhite) {
    for_each_alternative<ChromaticAdaptation>([](const auto& method) {
        SCOPED_TRACE(method.kName);
        for (const XYZd& from : kWhites) {
            for (const XYZd& to : kWhites) {
                const auto mapped = adaptation_matrix(method, from, to) * triple(from);
                for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(mapped[i], triple(to)[i], 1e-14);
            }
        }
    });
}

TEST(ChromaticAdaptation, SwappedWhitesAreTheInverse) {
    for_each_alternative<ChromaticAdaptation>([](const auto& method) {
        SCOPED_TRACE(method.kName);
        for (const XYZd& from : kWhites) {
            for (const XYZd& to : kWhites) {
                expect_near(adaptation_matrix(method, to, from) * adaptation_matrix(method, from, to), kIdentity,
                            1e-14);
            }
        }
    });
}

TEST(ChromaticAdaptation, GoesByAnyThirdWhite) {
    for_each_alternative<ChromaticAdaptation>([](const auto& method) {
        SCOPED_TRACE(method.kName);
        expect_near(adaptation_matrix(method, kD50, kD65) * adaptation_matrix(method, kA, kD50),
                    adaptation_matrix(method, kA, kD65), 1e-14);
    });
}

TEST(ChromaticAdaptation, IsExactlyNoneForEqualWhitesAndDegreeZero) {
    for_each_alternative<ChromaticAdaptation>([](const auto& method) {
        SCOPED_TRACE(method.kName);
        for (const double degree : {0.0, 0.3, 1.0}) {
            EXPECT_EQ(adaptation_matrix(method, kA, kA, degree), kIdentity);
        }
        EXPECT_EQ(adaptation_matrix(method, kA, kD65, 0.0), kIdentity);
    });
}

// The responses are scaled by D Rw' / Rw + 1 - D: the matrix is linear in D.
TEST(ChromaticAdaptation, OfADegreeLiesBetween) {
    for_each_alternative<ChromaticAdaptation>([](const auto& method) {
        SCOPED_TRACE(method.kName);
        const Matrix3 full = adaptation_matrix(method, kA, kD65), part = adaptation_matrix(method, kA, kD65, 0.7);
        Matrix3 wanted;
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) wanted.m[i][j] = 0.7 * full.m[i][j] + 0.3 * kIdentity.m[i][j];
        }
        expect_near(part, wanted, 1e-15);
    });
}

// CIE 159:2004, with a white of Yw = 100: Rc = R (Yw D / Rw + 1 - D). Ours is the same to illuminant E, whose
// CAT02 responses are 100 as the rows of CAT02 sum to 1.
TEST(ChromaticAdaptation, ToIlluminantEIsCiecams) {
    constexpr double kDegree = 0.6;
    const Matrix3 cone = cone_from_xyz(Cat02Adaptation{});
    const std::array<double, 3> colour = {19.31, 23.93, 10.14}, white = triple(100.0 * kA);
    const auto wanted = cone * colour, white_cone = cone * white;
    const auto got = cone * (adaptation_matrix(Cat02Adaptation{}, kA, kE, kDegree) * colour);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(got[i], wanted[i] * (100.0 * kDegree / white_cone[i] + 1.0 - kDegree), 1e-12);
    }
}

// Lindbloom, "Chromatic Adaptation", to the seven decimals printed.
TEST(ChromaticAdaptation, HasThePublishedMatrices) {
    constexpr double kPrinted = 0.51e-7;
    expect_near(adaptation_matrix(BradfordAdaptation{}, kA, kD65),
                {{{{{0.8446965, -0.1179225, 0.3948108}},
                   {{-0.1366303, 1.1041226, 0.1291718}},
                   {{0.0798489, -0.1348999, 3.1924009}}}}},
                kPrinted);
    expect_near(adaptation_matrix(BradfordAdaptation{}, kD50, kD65),
                {{{{{0.9555766, -0.0230393, 0.0631636}},
                   {{-0.0282895, 1.0099416, 0.0210077}},
                   {{0.0122982, -0.0204830, 1.3299098}}}}},
                kPrinted);
    expect_near(
        adaptation_matrix(VonKriesAdaptation{}, kA, kD65),
        {{{{{0.9394987, -0.2339150, 0.4281177}}, {{-0.0256939, 1.0263828, 0.0051761}}, {{0.0, 0.0, 3.0598005}}}}},
        kPrinted);
    expect_near(adaptation_matrix(XyzScalingAdaptation{}, kA, kD65),
                {{{{{0.8652435, 0.0, 0.0}}, {{0.0, 1.0, 0.0}}, {{0.0, 0.0, 3.0598005}}}}}, kPrinted);
}

// The example in the documentation of colour-science's matrix_chromatic_adaptation_VonKries, cut off at 7 decimals.
TEST(ChromaticAdaptation, OfCat02HasThePublishedMatrix) {
    expect_near(adaptation_matrix(Cat02Adaptation{}, {0.95045593, 1.0, 1.08905775}, {0.96429568, 1.0, 0.82510460}),
                {{{{{1.0425738, 0.0308910, -0.0528125}},
                   {{0.0221934, 1.0018566, -0.0210737}},
                   {{-0.0011648, -0.0034205, 0.7617890}}}}},
                1e-7);
}

TEST(ChromaticAdaptation, ResponsesToWhiteOfCats) {
    // Rows of CAT02 and CAT16 sum to 1, so that illuminant E has equal responses; Hunt-Pointer-Estevez has D65 so.
    for (const ChromaticAdaptation& method : {ChromaticAdaptation{Cat02Adaptation{}}, {Cat16Adaptation{}}}) {
        for (const double response : cone_from_xyz(method) * triple(kE)) EXPECT_NEAR(response, 1.0, 1e-12);
    }
    for (const double response : cone_from_xyz(VonKriesAdaptation{}) * triple(kD65)) EXPECT_NEAR(response, 1.0, 3e-4);
}

TEST(ChromaticAdaptation, RefusesBadWhitesAndDegrees) {
    for_each_alternative<ChromaticAdaptation>([](const auto& method) {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        for (const XYZd& bad :
             {XYZd{0.0, 0.0, 0.0}, XYZd{0.9, 1.0, -0.5}, XYZd{nan, 1.0, 1.0}, XYZd{1.0, kInfinity, 1.0}}) {
            EXPECT_THAT([&] { (void)adaptation_matrix(method, bad, kD65); },
                        ThrowsMessage<std::invalid_argument>(
                            AllOf(HasSubstr(std::string(method.kName)), HasSubstr("from-white XYZ"))));
            EXPECT_THAT([&] { (void)adaptation_matrix(method, kD65, bad); },
                        ThrowsMessage<std::invalid_argument>(HasSubstr("to-white XYZ")));
        }
        for (const double degree : {-0.1, 1.1, nan}) {
            EXPECT_THAT([&] { (void)adaptation_matrix(method, kA, kD65, degree); },
                        ThrowsMessage<std::invalid_argument>(HasSubstr("degree")));
        }
    });
    EXPECT_THAT(
        [] {
            (void)adaptation_matrix(XyzScalingAdaptation{}, {0.9, 1.0, 0.0}, kD65);
        },
        ThrowsMessage<std::invalid_argument>("adaptation xyz-scaling: from-white XYZ 0.9, 1, 0 has the responses "
                                             "0.9, 1, 0: all must be in (0, inf)"));
    EXPECT_THAT([] { (void)adaptation_matrix(Cat02Adaptation{}, kA, kD65, 1.5); },
                ThrowsMessage<std::invalid_argument>("adaptation cat02: degree = 1.5: must be in [0, 1]"));
}

}  // namespace
}  // namespace emulsion
