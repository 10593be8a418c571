#pragma once
// Where quantizers get encoded values from: a picture in memory, or stages that make them when they are asked for, so
// that no picture of them is ever written.

#include <algorithm>
#include <functional>
#include <span>
#include <vector>

#include "core/color.h"
#include "core/image.h"
#include "core/row_blocks.h"
#include "display/component_rows.h"

namespace emulsion {

/// Writes the encoded pixels of row y from column x0 on, as many as `pixels` takes. Quantizers ask once for every
/// pixel, in any order and on several threads at a time, but never on two for the same row.
using MakeEncoded = std::function<void(int y, int x0, std::span<RGB> pixels)>;

class EncodedSource {
  public:
    /// Of a picture that outlives this. Not explicit: it is one.
    EncodedSource(const EncodedRows& rows);  // NOLINT(google-explicit-constructor)
    /// Of RGB that `make` makes.
    EncodedSource(int width, int height, MakeEncoded make);

    [[nodiscard]] int width() const noexcept { return rows_.width; }
    [[nodiscard]] int height() const noexcept { return rows_.height; }
    [[nodiscard]] int channels() const noexcept { return rows_.channels; }

  private:
    friend class EncodedReader;
    friend class EncodedPicture;
    EncodedRows rows_;  // without data if they are made
    MakeEncoded make_;
};

/// How many pixels are made, and then rounded, before the next: few enough for the processor's first cache.
inline constexpr int kStretch_px = 1024;

/// Reads a source on one thread.
class EncodedReader {
  public:
    /// \param source outlives this
    explicit EncodedReader(const EncodedSource& source) noexcept : source_(&source) {}

    /// The components of pixels [x0, x1) of row y, until the next call.
    [[nodiscard]] std::span<const float> operator()(int y, int x0, int x1);

  private:
    const EncodedSource* source_;
    std::vector<RGB> room_;
};

/// Calls round(y, x0, encoded) for stretches that cover the source, with the components of pixels from x0 on: those of
/// a row from left to right, rows of a block in order on one thread. Each block has a `round` of its own, from
/// make_round(), which may work in memory that it keeps.
template <class MakeRound>
void for_each_stretch(const EncodedSource& source, int threads, const MakeRound& make_round) {
    const RowBlocks blocks(source.width(), source.height());
    parallel_for(0, blocks.count(), threads, [&](int block) {
        EncodedReader read(source);
        auto round = make_round();
        for (int y = blocks.first_row(block); y < blocks.first_row(block + 1); ++y) {
            for (int x0 = 0; x0 < source.width(); x0 += kStretch_px) {
                round(y, x0, read(y, x0, std::min(source.width(), x0 + kStretch_px)));
            }
        }
    });
}

/// The rows of a source from `first_row` on, in memory.
class EncodedPicture {
  public:
    /// \param source outlives this
    EncodedPicture(const EncodedSource& source, int first_row, int threads);

    [[nodiscard]] const EncodedRows& rows() const noexcept { return rows_; }

  private:
    Image<RGB> made_;
    EncodedRows rows_{};
};

}  // namespace emulsion
