#pragma once
// Rows of a picture as floats, several channels side by side, for what goes over pixels and coarser levels alike.

#include <functional>
#include <span>

#include "core/image.h"
#include "tonemap/axis_halving.h"

namespace emulsion {

/// Where rows come from. load(y, row) fills in width * channels floats; any thread may call it at any time.
struct LightRows {
    int width = 0, height = 0, channels = 0;
    std::function<void(int y, std::span<float> row)> load;
};

/// The rows of an image of width * channels floats, which must outlive them.
[[nodiscard]] LightRows rows_of(const Image<float>& image, int channels);

/// Both axes halved: means of the light, half_size() of x times channels floats a row.
/// The same bits for every number of threads (0: all). \throws std::invalid_argument if threads < 0.
[[nodiscard]] Image<float> halved(const LightRows& light, const AxisHalving& x, const AxisHalving& y, int threads);

/// Adds row y of what `half`, which has half the size, comes to at full size.
void add_doubled_row(const Image<float>& half, int channels, const AxisHalving& x, const AxisHalving& y, int row,
                     std::span<float> sum);

}  // namespace emulsion
