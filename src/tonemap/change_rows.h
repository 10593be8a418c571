#pragma once
// Changing a picture in its place, row by row, where each row depends on those about it as they were.

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "core/image.h"
#include "core/parallel.h"
#include "tonemap/mirrored_border.h"

namespace emulsion {

/// The rows of a band [begin, end) of a picture, and `radius` rows more on either side (mirrored_border.h), as they
/// were before the band or its neighbours were changed.
class OriginalRows {
  public:
    /// `picture` must outlive this.
    OriginalRows(Image<float>& picture, int begin, int end, int radius) noexcept
        : picture_(&picture), begin_(begin), end_(end), radius_(radius) {}

    /// To be called before anything is changed.
    void keep_border();

    /// Rows y - radius to y + radius, for y = begin, begin + 1, ... in turn: row y may be changed after this, and no
    /// later one. They are good until the next call.
    [[nodiscard]] std::span<const float* const> about(int y);

  private:
    [[nodiscard]] float* kept(int y) noexcept { return kept_.row(y % kept_.height()).data(); }

    Image<float>* picture_;
    int begin_, end_, radius_;
    Image<float> border_;  ///< those above the band, then those below; no rows if the radius is 0
    Image<float> kept_;    ///< of the band, those that may be changed already
    std::vector<const float*> rows_;
};

/// Calls body(y, rows) for every row y of the picture, which it may change: rows[radius + j] is row y + j as it was,
/// mirrored_border.h beyond the edges. `make_body()` gives a body for each band of rows, which has it to itself.
/// Threads as in parallel_for. \throws std::invalid_argument if threads < 0.
template <class MakeBody>
void change_rows(Image<float>& picture, int radius, int threads, const MakeBody& make_body) {
    constexpr int kBand = 64;
    const int height = picture.height(), bands = height / kBand + (height % kBand != 0 ? 1 : 0);
    std::vector<OriginalRows> originals;
    originals.reserve(static_cast<std::size_t>(bands));
    for (int band = 0; band < bands; ++band) {
        originals.emplace_back(picture, band * kBand, std::min(height, (band + 1) * kBand), radius);
    }
    parallel_for(0, bands, threads, [&](int band) { originals[static_cast<std::size_t>(band)].keep_border(); });
    parallel_for(0, bands, threads, [&](int band) {
        auto body = make_body();
        for (int y = band * kBand; y < std::min(height, (band + 1) * kBand); ++y) {
            body(y, originals[static_cast<std::size_t>(band)].about(y));
        }
    });
}

}  // namespace emulsion
