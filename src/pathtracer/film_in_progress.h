#pragma once
// A film that is being rendered, in step with the account of which samples it has. Tiles come in from many threads; at
// any moment another one may take a copy of both that belong together, from which a later render goes on.

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "core/image.h"
#include "film/film.h"
#include "film/film_provenance.h"

namespace emulsion {

/// The side of the tiles of new rounds. It doesn't show in the picture, whose sums are exact.
inline constexpr int kTileSize_px = 16;

/// Samples that all pixels get before any gets further ones, and the side of the tiles in which they do. Tiles are
/// counted row by row over the film's sample bounds; those at the right and at the bottom may be smaller.
struct RenderRound {
    SampleRange samples;
    int tile_px = 0;
    std::vector<std::size_t> tiles;  ///< that are missing
    bool operator==(const RenderRound&) const = default;
};

/// How many tiles cover `places`; `tile_px` >= 1.
[[nodiscard]] std::size_t tile_count(const PixelBounds& places, int tile_px) noexcept;
[[nodiscard]] PixelBounds tile_bounds(const PixelBounds& places, int tile_px, std::size_t tile) noexcept;

class FilmInProgress {
  public:
    /// `film` must outlive this, and nobody else may add to it meanwhile. `provenance` tells what it has already.
    /// \throws std::invalid_argument if a partial round there has other tiles than its film has.
    FilmInProgress(Film& film, FilmProvenance provenance);

    [[nodiscard]] const Film& film() const noexcept { return film_; }
    [[nodiscard]] FilmProvenance provenance() const;

    /// read(film, provenance), both as they belong together: tiles wait outside meanwhile.
    template <class Read>
    auto read(const Read& read) const {
        const std::lock_guard lock(mutex_);
        return read(std::as_const(film_), std::as_const(provenance_));
    }

    /// What comes next towards all samples of `wanted`: the rest of a partial round, whether wanted or not; else the
    /// first samples that are missing, as many as there are already, from 1 to 16, and up to a multiple of 16. So a
    /// picture is soon whole, if noisy. None if nothing is missing but in tiles that are left out.
    [[nodiscard]] std::optional<RenderRound> next_round(SampleRange wanted) const;
    /// From the next round on, tiles of kTileSize_px with a 1 get no samples: they have enough.
    /// \throws std::invalid_argument if there are not as many tiles.
    void leave_out(std::vector<std::uint8_t> tiles);
    [[nodiscard]] std::size_t tiles_left_out() const;
    /// Adds the samples of a missing tile of that round, and notes that it is done; with the last one, that the round
    /// is.
    void merge(const FilmTile& samples, const RenderRound& round, std::size_t tile);

    /// Paths to trace until the film has all samples of `wanted`: in all pixels of the film's sample bounds, those of
    /// tiles that are left out excepted.
    [[nodiscard]] std::int64_t missing_paths(SampleRange wanted) const;

  private:
    /// Those that are not left out; with the lock held.
    [[nodiscard]] std::vector<std::size_t> tiles_of_rounds() const;

    Film& film_;
    mutable std::mutex mutex_;  // guards what tiles add to the film, and all below
    FilmProvenance provenance_;
    std::size_t tiles_left_ = 0;          // of the partial round
    std::vector<std::uint8_t> left_out_;  // empty: none
};

}  // namespace emulsion
