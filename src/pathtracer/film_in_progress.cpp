#include "pathtracer/film_in_progress.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace emulsion {

namespace {

/// Neither shows in the picture: the film's sums are exact.
constexpr int kTileSize_px = 16;
constexpr std::uint64_t kSamplesPerRound = 16;

std::size_t tiles_along(int size_px, int tile_px) noexcept {
    return (static_cast<std::size_t>(size_px) + static_cast<std::size_t>(tile_px) - 1) /
           static_cast<std::size_t>(tile_px);
}

std::int64_t pixel_count(const PixelBounds& bounds) noexcept {
    return static_cast<std::int64_t>(bounds.width()) * bounds.height();
}

void require_tiles(const PartialRound& partial, const PixelBounds& places) {
    const std::size_t expected = partial.tile_px >= 1 ? tile_count(places, partial.tile_px) : 0;
    if (expected > 0 && partial.done.size() == expected) return;
    throw std::invalid_argument("film in progress: its partial round has " + std::to_string(partial.done.size()) +
                                " tiles of " + std::to_string(partial.tile_px) + " pixels, expected " +
                                std::to_string(expected) + " over " + to_string(places));
}

}  // namespace

std::size_t tile_count(const PixelBounds& places, int tile_px) noexcept {
    return tiles_along(places.width(), tile_px) * tiles_along(places.height(), tile_px);
}

PixelBounds tile_bounds(const PixelBounds& places, int tile_px, std::size_t tile) noexcept {
    const std::size_t columns = tiles_along(places.width(), tile_px);
    const int x0 = places.x0 + static_cast<int>(tile % columns) * tile_px;
    const int y0 = places.y0 + static_cast<int>(tile / columns) * tile_px;
    return {x0, y0, std::min(x0 + tile_px, places.x1), std::min(y0 + tile_px, places.y1)};
}

FilmInProgress::FilmInProgress(Film& film, FilmProvenance provenance)
    : film_(film), provenance_(std::move(provenance)) {
    if (!provenance_.partial) return;
    const PartialRound& partial = *provenance_.partial;
    require_tiles(partial, film_.sample_bounds());
    tiles_left_ = static_cast<std::size_t>(std::count(partial.done.begin(), partial.done.end(), 0));
    if (tiles_left_ > 0) return;
    provenance_.samples.add(partial.samples);
    provenance_.partial.reset();
}

FilmProvenance FilmInProgress::provenance() const {
    const std::lock_guard lock(mutex_);
    return provenance_;
}

std::optional<RenderRound> FilmInProgress::next_round(SampleRange wanted) const {
    const std::lock_guard lock(mutex_);
    RenderRound round;
    if (const auto& partial = provenance_.partial) {
        round = {partial->samples, partial->tile_px, {}};
        for (std::size_t i = 0; i < partial->done.size(); ++i) {
            if (partial->done[i] == 0) round.tiles.push_back(i);
        }
        return round;
    }
    const std::vector<SampleRange> missing = provenance_.samples.missing(wanted);
    if (missing.empty()) return std::nullopt;
    const SampleRange& first = missing.front();
    const std::uint64_t size = std::clamp(provenance_.samples.count(), std::uint64_t{1}, kSamplesPerRound);
    round = {{first.begin, std::min(first.begin + size, first.end)}, kTileSize_px, {}};
    round.tiles.resize(tile_count(film_.sample_bounds(), round.tile_px));
    std::iota(round.tiles.begin(), round.tiles.end(), std::size_t{0});
    return round;
}

void FilmInProgress::merge(const FilmTile& samples, const RenderRound& round, std::size_t tile) {
    const std::lock_guard lock(mutex_);
    auto& partial = provenance_.partial;
    if (!partial) {
        tiles_left_ = tile_count(film_.sample_bounds(), round.tile_px);
        partial = PartialRound{round.samples, round.tile_px, std::vector<std::uint8_t>(tiles_left_)};
    }
    film_.merge(samples);
    partial->done.at(tile) = 1;
    if (--tiles_left_ > 0) return;
    provenance_.samples.add(round.samples);
    partial.reset();
}

std::int64_t FilmInProgress::missing_paths(SampleRange wanted) const {
    const std::lock_guard lock(mutex_);
    const PixelBounds& places = film_.sample_bounds();
    SampleRanges had = provenance_.samples;
    std::int64_t paths = 0;
    if (const auto& partial = provenance_.partial) {
        for (std::size_t i = 0; i < partial->done.size(); ++i) {
            if (partial->done[i] != 0) continue;
            paths += pixel_count(tile_bounds(places, partial->tile_px, i)) *
                     static_cast<std::int64_t>(partial->samples.size());
        }
        had.add(partial->samples);
    }
    for (const SampleRange& range : had.missing(wanted)) {
        paths += pixel_count(places) * static_cast<std::int64_t>(range.size());
    }
    return paths;
}

}  // namespace emulsion
