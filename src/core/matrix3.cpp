#include "core/matrix3.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

namespace emulsion {

namespace {

/// A bound on the rounding error of determinant(a): that of its six products of three, each rounded up to five times.
double determinant_rounding(const Matrix3& a) noexcept {
    double products = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        products += std::abs(a.m[0][i]) * (std::abs(a.m[1][j] * a.m[2][k]) + std::abs(a.m[1][k] * a.m[2][j]));
    }
    return 8.0 * std::numeric_limits<double>::epsilon() * products;
}

}  // namespace

Matrix3 operator*(const Matrix3& a, const Matrix3& b) noexcept {
    Matrix3 product;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            for (std::size_t k = 0; k < 3; ++k) product.m[i][j] += a.m[i][k] * b.m[k][j];
        }
    }
    return product;
}

std::array<double, 3> operator*(const Matrix3& a, const std::array<double, 3>& v) noexcept {
    std::array<double, 3> product{};
    for (std::size_t i = 0; i < 3; ++i) product[i] = a.m[i][0] * v[0] + a.m[i][1] * v[1] + a.m[i][2] * v[2];
    return product;
}

double determinant(const Matrix3& a) noexcept {
    const auto& m = a.m;
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

Matrix3 inverse(const Matrix3& a) {
    double scale = 0.0;
    for (const auto& row : a.m) {
        for (const double element : row) {
            if (!std::isfinite(element)) {
                throw std::invalid_argument("matrix: element " + std::to_string(element) + ", expected a finite one");
            }
            scale = std::max(scale, std::abs(element));
        }
    }

    // Elements of at most 1, so that no product of three leaves the range of a double.
    Matrix3 unit = a;
    if (scale > 0.0) {
        for (auto& row : unit.m) {
            for (double& element : row) element /= scale;
        }
    }
    const auto& m = unit.m;
    const double det = determinant(unit);
    if (std::abs(det) <= determinant_rounding(unit)) {
        throw std::invalid_argument("matrix: singular, expected an invertible one");
    }

    // Transposed cofactors over the determinant; cyclic indices give the signs.
    Matrix3 inverted;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t r0 = (j + 1) % 3, r1 = (j + 2) % 3, c0 = (i + 1) % 3, c1 = (i + 2) % 3;
            inverted.m[i][j] = (m[r0][c0] * m[r1][c1] - m[r0][c1] * m[r1][c0]) / det / scale;
        }
    }
    return inverted;
}

}  // namespace emulsion
