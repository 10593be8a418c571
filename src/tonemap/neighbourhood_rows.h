#pragma once
// The inner loops of averages over neighbourhoods: rows of luminances, in vectors as wide as the processor has. Every
// value is computed in the same order, with the same bits for every width and wherever in a row it is.

#include <span>

#include "core/color.h"

namespace emulsion {

/// Luminances over a unit: out[x] = min(Y * per_unit, most), or -1 where a pixel is bad or Y >= least_outlier.
/// \return whether any is -1
bool relative_row(std::span<const XYZ> in, float per_unit, float least_outlier, float most, std::span<float> out);

/// out[i] = the sum of kernel[|j|] taps[r + j][i] over all j in [-r, r]: kernel has r + 1 weights, the same before and
/// behind the middle, taps 2 r + 1 arrays.
void convolve(std::span<const float> kernel, std::span<const float* const> taps, std::span<float> out);

/// out[i] = the sum of weights[k] rows[k][i] over all k; one weight or more, and as many rows.
void add_rows(std::span<const float> weights, std::span<const float* const> rows, std::span<float> out);

/// Half a row, weighted by 1 3 3 1: half[i] = ((in[2 i - 1] + in[2 i + 2]) + 3 (in[2 i] + in[2 i + 1])) / 8; `in` has
/// one value before its first.
void halve_row(const float* in, std::span<float> half);

/// A row of twice the size: out[2 i] = (3 in[i] + in[i - 1]) / 4, out[2 i + 1] = (3 in[i] + in[i + 1]) / 4; `in` has
/// one value before its first and one behind its last.
void double_row(const float* in, std::span<float> out);

/// The rows that one scale is decided by: averages of the scale before, of this one and of the next.
struct ScaleRows {
    const float *before, *centre, *surround;
    float floor, limit;  ///< ScaleSelection
};

/// `scales` from the widest on; `row` has what comes of accepting all of them, and gets what comes of deciding.
void decide_row(std::span<const ScaleRows> scales, std::span<float> row);

}  // namespace emulsion
