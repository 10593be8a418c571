#pragma once
// Plain colour triples. What they are relative to is said where they are used: scene-referred XYZ has Y in cd/m^2,
// display-referred XYZ has Y = 1 at display white.

namespace emulsion {

/// CIE tristimulus values.
template <class T>
struct BasicXYZ {
    T x{}, y{}, z{};
    bool operator==(const BasicXYZ&) const = default;
};
using XYZ = BasicXYZ<float>;
using XYZd = BasicXYZ<double>;

/// Red, green and blue of the RGB space named beside it; linear unless said to be encoded.
template <class T>
struct BasicRGB {
    T r{}, g{}, b{};
    bool operator==(const BasicRGB&) const = default;
};
using RGB = BasicRGB<float>;
using RGBd = BasicRGB<double>;

template <class T>
[[nodiscard]] constexpr BasicXYZ<T> operator+(BasicXYZ<T> a, BasicXYZ<T> b) noexcept {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
[[nodiscard]] constexpr BasicXYZ<T> operator*(T s, BasicXYZ<T> a) noexcept {
    return {s * a.x, s * a.y, s * a.z};
}
template <class T>
[[nodiscard]] constexpr BasicRGB<T> operator+(BasicRGB<T> a, BasicRGB<T> b) noexcept {
    return {a.r + b.r, a.g + b.g, a.b + b.b};
}
template <class T>
[[nodiscard]] constexpr BasicRGB<T> operator*(T s, BasicRGB<T> a) noexcept {
    return {s * a.r, s * a.g, s * a.b};
}

}  // namespace emulsion
