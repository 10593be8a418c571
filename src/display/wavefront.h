#pragma once
// Which parts of a picture may be worked on when every pixel waits for those to its left and for the row above it as
// far as a few pixels past it.

#include <condition_variable>
#include <mutex>
#include <optional>
#include <vector>

namespace emulsion {

/// Some rows, and a number of columns of them. A tile leans to the left by `reach` pixels a row, so that each of its
/// rows finds the one above it done that far past its own end.
struct WavefrontTile {
    int y0, y1;  ///< rows [y0, y1)
    int end;     ///< columns of row y0 up to here, or all
    int band, number;
};

/// Gives out the tiles of a picture. Bands of rows lie below each other, tiles of a band follow from left to right.
/// A tile is given out once the one before it in its band is done, and in the band above the tile after the one above
/// it. Whoever is free takes the uppermost of those, so that a thread that is held up holds up what is right of its
/// tile and no more. Bands under way at one time are bounded, for the sake of memory.
class Wavefront {
  public:
    /// All of the picture's rows [0, height); `reach` in pixels.
    Wavefront(int width, int height, int reach, int threads);

    [[nodiscard]] int rows_of_band() const noexcept { return rows_; }
    /// No more than so many, from any band under way, may be under way or have been begun.
    [[nodiscard]] int bands_at_once() const noexcept { return bands_at_once_; }

    /// A tile to do, once there is one; none when all have been given out to the last. Then call done().
    [[nodiscard]] std::optional<WavefrontTile> take();
    void done(const WavefrontTile& tile);

    /// Where a tile ends in row y of it.
    [[nodiscard]] int end_of(const WavefrontTile& tile, int y) const noexcept;

  private:
    struct Band {
        int taken = 0, done = 0;  ///< tiles
    };
    [[nodiscard]] bool is_ready(int band) const noexcept;

    int width_, height_, reach_, rows_, columns_, tiles_, bands_at_once_;
    std::vector<Band> bands_;
    int first_ = 0;  ///< band that is not done
    std::mutex mutex_;
    std::condition_variable changed_;
};

}  // namespace emulsion
