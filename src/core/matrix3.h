#pragma once
// 3x3 matrices for colour, in double precision. A matrix is named target-from-source: xyz_from_rgb * rgb = xyz.

#include <array>

namespace emulsion {

struct Matrix3 {
    std::array<std::array<double, 3>, 3> m{};  ///< m[row][column]
    bool operator==(const Matrix3&) const = default;
};

[[nodiscard]] Matrix3 operator*(const Matrix3& a, const Matrix3& b) noexcept;
[[nodiscard]] std::array<double, 3> operator*(const Matrix3& a, const std::array<double, 3>& v) noexcept;
[[nodiscard]] double determinant(const Matrix3& a) noexcept;

/// \throws std::invalid_argument if an element is not finite, or the determinant is 0 to within rounding.
[[nodiscard]] Matrix3 inverse(const Matrix3& a);

}  // namespace emulsion
