#include "core/matrix3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"

namespace emulsion {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr Matrix3 kIdentity{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};

Matrix3 scaled(const Matrix3& a, double s) {
    Matrix3 b = a;
    for (auto& row : b.m) {
        for (double& element : row) element *= s;
    }
    return b;
}

double largest_difference(const Matrix3& a, const Matrix3& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) largest = std::max(largest, std::abs(a.m[i][j] - b.m[i][j]));
    }
    return largest;
}

TEST(Matrix3, MultipliesRowsByColumns) {
    constexpr Matrix3 kA{{{{1, 2, 3}, {4, 5, 6}, {7, 8, 10}}}};
    constexpr Matrix3 kB{{{{0, 1, 0}, {2, 0, 0}, {0, 0, 3}}}};
    constexpr Matrix3 kProduct{{{{4, 1, 9}, {10, 4, 18}, {16, 7, 30}}}};
    EXPECT_EQ(kA * kB, kProduct);
    EXPECT_NE(kB * kA, kProduct);
    EXPECT_THAT((kA * std::array<double, 3>{1, 0, -1}), ElementsAre(-2, -2, -3));
    EXPECT_EQ(determinant(kA), -3.0);
}

TEST(Matrix3, InverseOfAKnownMatrix) {
    constexpr Matrix3 kA{{{{1, 2, 3}, {4, 5, 6}, {7, 8, 10}}}};
    constexpr Matrix3 kInverse{{{{-2.0 / 3, -4.0 / 3, 1}, {-2.0 / 3, 11.0 / 3, -2}, {1, -2, 1}}}};
    EXPECT_LT(largest_difference(inverse(kA), kInverse), 1e-13);
}

TEST(Matrix3, InverseTimesItselfIsTheIdentityAtEveryScale) {
    Pcg32 random(1);
    for (int trial = 0; trial < 1000; ++trial) {
        Matrix3 a;
        for (auto& row : a.m) {
            for (double& element : row) element = 2.0 * random.next_float() - 1.0;
        }
        if (std::abs(determinant(a)) < 1e-3) continue;
        for (const double scale : {1e-200, 1.0, 1e200}) {
            const Matrix3 b = scaled(a, scale);
            // Elements below 1, determinant above 1e-3: the inverse is below 2e3, and each product loses few bits of
            // it.
            EXPECT_LT(largest_difference(b * inverse(b), kIdentity), 1e-11) << "trial " << trial << ", scale " << scale;
        }
    }
}

TEST(Matrix3, InverseUndoesTheWhitePointOfADisplay) {
    // BT.709 with D65 (ITU-R BT.709-6), to six digits.
    constexpr Matrix3 kXyzFromRgb{
        {{{0.412391, 0.357584, 0.180481}, {0.212639, 0.715169, 0.072192}, {0.019331, 0.119195, 0.950532}}}};
    const std::array<double, 3> white = kXyzFromRgb * std::array<double, 3>{1, 1, 1};
    EXPECT_THAT(inverse(kXyzFromRgb) * white,
                ElementsAre(DoubleNear(1, 1e-14), DoubleNear(1, 1e-14), DoubleNear(1, 1e-14)));
}

TEST(Matrix3, NoInverseOfASingularMatrix) {
    constexpr Matrix3 kDependentRows{{{{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}, {0.7, 0.8, 0.9}}}};
    EXPECT_NE(determinant(kDependentRows), 0.0) << "singular but for rounding: what this case is about";
    for (const Matrix3& singular : {Matrix3{}, kDependentRows, Matrix3{{{{1, 1, 1}, {1, 1, 1}, {0, 0, 1}}}}}) {
        EXPECT_THAT([&] { (void)inverse(singular); }, ThrowsMessage<std::invalid_argument>(HasSubstr("singular")));
    }
}

TEST(Matrix3, NoInverseOfWhatIsNotFinite) {
    for (const double bad : {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()}) {
        for (std::size_t i = 0; i < 9; ++i) {
            Matrix3 a = kIdentity;
            a.m[i / 3][i % 3] = bad;
            EXPECT_THROW((void)inverse(a), std::invalid_argument) << bad << " at " << i;
        }
    }
}

}  // namespace
}  // namespace emulsion
