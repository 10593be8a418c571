#pragma once
// Light that spreads over a picture. Every step is a matrix of weights >= 0 whose rows add up to 1, and whose columns
// do, too: a constant stays as it is, and the sum over the picture is that of before, at edges as well. The picture is
// mirrored at its edges for that: what would leave it comes back.

#include <functional>
#include <span>

#include "tonemap/light_rows.h"

namespace emulsion {

/// A part of a kernel, peak exp(-d^2 / (2 sigma^2)), d in pixels.
struct GaussianLobe {
    double sigma_px = 1.0;  ///< > 0
    double peak = 1.0;      ///< >= 0; relative to those of the others
};

/// What is done with a row; called once for each row, by any thread, in no particular order.
using TakeRow = std::function<void(int y, std::span<const float> row)>;

/// The light convolved with the sum of the lobes, divided by its sum over all pixels. Wide lobes are worked out on
/// coarser levels, each where it is one to three samples wide, so that the cost does not depend on their width. Needs
/// two thirds of a picture of memory. The same bits for every number of threads (0: all).
/// \throws std::invalid_argument if threads < 0.
void scatter(std::span<const GaussianLobe> lobes, const LightRows& light, int threads, const TakeRow& take);

}  // namespace emulsion
