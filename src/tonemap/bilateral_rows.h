#pragma once
// The inner loops of the bilateral filter: rows of luminances and a grid of sums, in vectors as wide as the processor
// has. The same bits for every width.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace emulsion {

struct PositiveRange {
    float least = std::numeric_limits<float>::infinity();  ///< infinity: no value is positive
    float most = 0.0f;
};
[[nodiscard]] PositiveRange positive_range(std::span<const float> row);

/// Every value becomes its log2, that of `least` if it is less; at least that of 2^-126. Within 2e-7 absolutely or
/// 2e-7 relatively. Values are in [0, 2^127).
void log2_row(float least, std::span<float> row);

/// The levels of a grid: places between them are (value - least) / step.
struct GridLevels {
    float least = 0.0f, step = 1.0f;
    std::uint32_t count = 2;
};

/// What a node of the grid holds at each level: a sum of weights, and one of weighted places.
inline constexpr std::size_t kGridSums = 2;
/// What a cell has at each level: the sums of its four nodes; left and right of the row above, then of that below.
inline constexpr std::size_t kCellSums = 4 * kGridSums;
/// Of pixels in turn, so that none has to wait for the one before it.
inline constexpr std::size_t kCellCopies = 2;

/// Where each pixel of a row lies: kCellCopies of a cell's sums follow one another.
struct GridColumns {
    const std::uint32_t* cell_offset;   ///< of the pixel's copy in its cell, in floats
    const std::uint32_t *left, *right;  ///< offsets of the nodes in a row of nodes, in floats
    const float* across;  ///< four for each pixel: the share of the node to the left, twice, and to the right, twice
};

/// Adds every value of the row to the cells, weighted linearly. `below` is the share of the row of nodes below.
void spread_row(const GridLevels& levels, const GridColumns& columns, float below, std::span<const float> row,
                float* cells);

/// Every value becomes 2^(what the grid has in its place): `nodes` is the row of nodes, interpolated for this row.
void read_row(const GridLevels& levels, const GridColumns& columns, const float* nodes, std::span<float> row);

}  // namespace emulsion
