#include "pathtracer/film_in_progress.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace emulsion {

namespace {

/// Doesn't show in the picture, either.
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
    std::uint64_t end = first.begin + std::clamp(provenance_.samples.count(), std::uint64_t{1}, kSamplesPerRound);
    if (end - end % kSamplesPerRound > first.begin) end -= end % kSamplesPerRound;
    round = {{first.begin, std::min(end, first.end)}, kTileSize_px, tiles_of_rounds()};
    if (round.tiles.empty()) return std::nullopt;
    return round;
}

std::vector<std::size_t> FilmInProgress::tiles_of_rounds() const {
    std::vector<std::size_t> tiles;
    const std::size_t count = tile_count(film_.sample_bounds(), kTileSize_px);
    tiles.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        if (left_out_.empty() || left_out_[i] == 0) tiles.push_back(i);
    }
    return tiles;
}

void FilmInProgress::leave_out(std::vector<std::uint8_t> tiles) {
    const std::lock_guard lock(mutex_);
    const std::size_t expected = tile_count(film_.sample_bounds(), kTileSize_px);
    if (tiles.size() != expected) {
        throw std::invalid_argument("film in progress: " + std::to_string(tiles.size()) +
                                    " tiles to leave out or not, expected " + std::to_string(expected));
    }
    left_out_ = std::move(tiles);
}

std::size_t FilmInProgress::tiles_left_out() const {
    const std::lock_guard lock(mutex_);
    return static_cast<std::size_t>(std::count(left_out_.begin(), left_out_.end(), 1));
}

void FilmInProgress::merge(const FilmTile& samples, const RenderRound& round, std::size_t tile) {
    const std::lock_guard lock(mutex_);
    auto& partial = provenance_.partial;
    if (!partial) {
        tiles_left_ = round.tiles.size();
        partial = PartialRound{round.samples, round.tile_px,
                               std::vector<std::uint8_t>(tile_count(film_.sample_bounds(), round.tile_px), 1)};
        for (const std::size_t missing : round.tiles) partial->done[missing] = 0;
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
    std::int64_t pixels = 0;
    for (const std::size_t tile : tiles_of_rounds()) pixels += pixel_count(tile_bounds(places, kTileSize_px, tile));
    for (const SampleRange& range : had.missing(wanted)) paths += pixels * static_cast<std::int64_t>(range.size());
    return paths;
}

}  // namespace emulsion
