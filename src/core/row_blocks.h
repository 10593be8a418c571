#pragma once
// Parallel loops over the rows of a picture, in blocks large enough to be worth a task whatever the width.

#include <algorithm>

#include "core/parallel.h"

namespace emulsion {

/// Rows in a block of about 8192 pixels: depends on the width alone, never on the number of threads.
[[nodiscard]] constexpr int rows_per_block(int width) noexcept { return std::max(1, 8192 / std::max(1, width)); }

/// Calls body(y) once for every y in [0, height), rows of one block in order on one thread; threads as in parallel_for.
/// \throws std::invalid_argument if threads < 0.
template <class Body>
void parallel_for_rows(int width, int height, int threads, const Body& body) {
    const int block_height = rows_per_block(width);
    const int blocks = height / block_height + (height % block_height != 0 ? 1 : 0);
    parallel_for(0, blocks, threads, [&](int block) {
        const int begin = block * block_height;
        const int end = begin + std::min(block_height, height - begin);
        for (int y = begin; y < end; ++y) body(y);
    });
}

}  // namespace emulsion
