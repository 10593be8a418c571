#pragma once
// Parallel loops over the rows of a picture, in blocks large enough to be worth a task whatever the width.

#include <algorithm>

#include "core/parallel.h"

namespace emulsion {

/// Rows in a block of about 8192 pixels: depends on the width alone, never on the number of threads.
[[nodiscard]] constexpr int rows_per_block(int width) noexcept { return std::max(1, 8192 / std::max(1, width)); }

/// The rows of a picture, shared out.
class RowBlocks {
  public:
    RowBlocks(int width, int height) noexcept
        : height_(height), rows_(rows_per_block(width)), count_(height / rows_ + (height % rows_ != 0 ? 1 : 0)) {}

    [[nodiscard]] int count() const noexcept { return count_; }
    /// Of `block` in [0, count()]; the height for the last of these.
    [[nodiscard]] int first_row(int block) const noexcept { return block == count_ ? height_ : block * rows_; }

  private:
    int height_, rows_, count_;
};

/// Calls body(y) once for every y in [0, height), rows of one block in order on one thread; threads as in parallel_for.
/// \throws std::invalid_argument if threads < 0.
template <class Body>
void parallel_for_rows(int width, int height, int threads, const Body& body) {
    const RowBlocks blocks(width, height);
    parallel_for(0, blocks.count(), threads, [&](int block) {
        for (int y = blocks.first_row(block); y < blocks.first_row(block + 1); ++y) body(y);
    });
}

}  // namespace emulsion
