#pragma once
// Curves with a simple piece near 0 and a table above it: the inner loops of transfer functions.

#include <cmath>
#include <span>

#include "display/curve_table.h"

namespace emulsion {

/// offset + slope x for x <= last, the table above.
struct StraightToeCurve {
    float last = 0.0f, slope = 0.0f, offset = 0.0f;
    CurveTable above;

    [[nodiscard]] float operator()(float x) const noexcept { return x <= last ? offset + slope * x : above(x); }
};

/// sqrt(3 x) for x <= last, the table above.
struct SquareRootToeCurve {
    float last = 0.0f;
    CurveTable above;

    [[nodiscard]] float operator()(float x) const noexcept { return x <= last ? std::sqrt(3.0f * x) : above(x); }
};

/// Replaces each value by what the curve has there, to the bit.
void encode_row(const StraightToeCurve& curve, std::span<float> values) noexcept;
void encode_row(const SquareRootToeCurve& curve, std::span<float> values) noexcept;

}  // namespace emulsion
