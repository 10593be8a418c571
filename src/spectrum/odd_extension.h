#pragma once
// Functions given for values from 0 up, taken on to negative ones: f(-x) = -f(x).

namespace emulsion {

/// curve(x) for x >= 0, -curve(-x) below; NaN is passed to the curve.
template <class Curve>
[[nodiscard]] double odd(double x, const Curve& curve) noexcept {
    return x < 0.0 ? -curve(-x) : curve(x);
}

}  // namespace emulsion
