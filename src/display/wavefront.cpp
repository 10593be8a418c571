#include "display/wavefront.h"

#include <algorithm>
#include <cstddef>

namespace emulsion {

namespace {

constexpr int kRowsOfBand = 8;
constexpr int kMostColumns_px = 1024;  // 8 rows of them are some 60 us of work, much more than to take a tile
constexpr int kLeastColumns_px = 64;

}  // namespace

Wavefront::Wavefront(int width, int height, int reach, int threads)
    : width_(width),
      height_(height),
      reach_(reach),
      rows_(threads == 1 ? 1 : kRowsOfBand),
      columns_(threads == 1 ? width : std::clamp(width / (4 * threads), kLeastColumns_px, kMostColumns_px)),
      tiles_((width + columns_ - 1) / columns_),
      bands_at_once_(threads == 1 ? 1 : 2 * threads),
      bands_(static_cast<std::size_t>((height + rows_ - 1) / rows_)) {
    static_assert(kLeastColumns_px >= 2 * kRowsOfBand);  // the lean of a band is less than a tile
}

bool Wavefront::is_ready(int band) const noexcept {
    const Band& own = bands_[static_cast<std::size_t>(band)];
    if (own.taken != own.done || own.taken == tiles_) return false;
    return band == 0 || bands_[static_cast<std::size_t>(band) - 1].done >= std::min(tiles_, own.done + 2);
}

std::optional<WavefrontTile> Wavefront::take() {
    std::unique_lock lock(mutex_);
    const int bands = static_cast<int>(bands_.size());
    while (first_ < bands) {
        const int end = std::min(bands, first_ + bands_at_once_);
        for (int band = first_; band < end; ++band) {
            if (!is_ready(band)) continue;
            const int number = bands_[static_cast<std::size_t>(band)].taken++;
            const int y0 = band * rows_;
            return WavefrontTile{y0, std::min(height_, y0 + rows_), (number + 1) * columns_, band, number};
        }
        changed_.wait(lock);
    }
    return std::nullopt;
}

void Wavefront::done(const WavefrontTile& tile) {
    {
        const std::scoped_lock lock(mutex_);
        bands_[static_cast<std::size_t>(tile.band)].done = tile.number + 1;
        while (first_ < static_cast<int>(bands_.size()) && bands_[static_cast<std::size_t>(first_)].done == tiles_) {
            ++first_;
        }
    }
    changed_.notify_all();
}

int Wavefront::end_of(const WavefrontTile& tile, int y) const noexcept {
    if (tile.number + 1 == tiles_) return width_;
    return tile.end - reach_ * (y - tile.y0);
}

}  // namespace emulsion
