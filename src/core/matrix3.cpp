#include "core/matrix3.h"

#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace emulsion {

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
    const double det = determinant(a);
    if (!std::isfinite(det) || det == 0.0) throw std::invalid_argument("matrix: singular, expected an invertible one");
    const auto& m = a.m;
    // Transposed cofactors over the determinant; cyclic indices give the signs.
    Matrix3 inverted;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t r0 = (j + 1) % 3, r1 = (j + 2) % 3, c0 = (i + 1) % 3, c1 = (i + 2) % 3;
            inverted.m[i][j] = (m[r0][c0] * m[r1][c1] - m[r0][c1] * m[r1][c0]) / det;
        }
    }
    return inverted;
}

}  // namespace emulsion
