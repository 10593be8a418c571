#pragma once
// Solving for the tables of sigmoid_table.h. Runs when the library is built; some two seconds a space.

#include <vector>

#include "core/matrix3.h"
#include "spectrum/reflectance_weights.h"

namespace emulsion {

/// Centred coefficients times sqrt(z): [largest component][z][y][x][coefficient], 9 resolution^3 numbers. Each node is
/// solved for starting from its neighbour, with the exact solver's residual and a small penalty on the coefficients; so
/// neighbours are alike where several sigmoids do, and beyond the reach of any.
/// `relative_xyz_from_rgb` and the weights, which are those of XYZ, are white-relative. Resolution at least 2.
[[nodiscard]] std::vector<float> solve_sigmoid_table(const ReflectanceWeights& xyz_weights,
                                                     const Matrix3& relative_xyz_from_rgb, int resolution);

}  // namespace emulsion
