#include "display/void_and_cluster.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/random.h"

namespace emulsion {

namespace {

constexpr double kSigma_px = 1.5;
constexpr double kWideSigma_px = 8.0 * kSigma_px;
constexpr double kWideHeight = 0x1p-24;
constexpr double kUnit = 0x1p56;  // the sum over a tile stays below 2^63: 2 pi 1.5^2 times this is 2^59.8
constexpr int kDotsInTen = 1;     // of the pattern that ranks start from

using Energy = std::int64_t;

/// A pattern of dots on a tile, with its energies.
class DotPattern {
  public:
    explicit DotPattern(int size) : size_(static_cast<std::size_t>(size)), dots_(size_ * size_), energy_(dots_.size()) {
        // Twice as wide and high as the tile, so that the one around any pixel is a part of it
        const std::size_t span = 2 * size_;
        for (std::size_t y = 0; y < span; ++y) {
            for (std::size_t x = 0; x < span; ++x) around_.push_back(gaussian(distance(x), distance(y)));
        }
    }

    [[nodiscard]] bool has(std::size_t i) const noexcept { return dots_[i] != 0; }
    void put(std::size_t i) noexcept { dots_[i] = 1, add_around<1>(i); }
    void take(std::size_t i) noexcept { dots_[i] = 0, add_around<-1>(i); }

    /// The dot with most energy.
    [[nodiscard]] std::size_t tightest_cluster() const noexcept {
        std::size_t best = 0;
        Energy most = -1;
        for (std::size_t i = 0; i < dots_.size(); ++i) {
            if (dots_[i] != 0 && energy_[i] > most) most = energy_[i], best = i;
        }
        return best;
    }

    /// The pixel without a dot that has least energy.
    [[nodiscard]] std::size_t largest_void() const noexcept {
        std::size_t best = 0;
        Energy least = std::numeric_limits<Energy>::max();
        for (std::size_t i = 0; i < dots_.size(); ++i) {
            if (dots_[i] == 0 && energy_[i] < least) least = energy_[i], best = i;
        }
        return best;
    }

  private:
    /// To the nearest repetition of the pixel 0.
    [[nodiscard]] double distance(std::size_t offset) const noexcept {
        return static_cast<double>(std::min(offset % size_, size_ - offset % size_));
    }
    [[nodiscard]] static Energy gaussian(double dx, double dy) noexcept {
        const double square = dx * dx + dy * dy;
        return std::llround(kUnit * (std::exp(-square / (2.0 * kSigma_px * kSigma_px)) +
                                     kWideHeight * std::exp(-square / (2.0 * kWideSigma_px * kWideSigma_px))));
    }

    template <Energy Sign>
    void add_around(std::size_t i) noexcept {
        const std::size_t column = i % size_, row = i / size_;
        for (std::size_t y = 0; y < size_; ++y) {
            const Energy* around = &around_[(y + size_ - row) * 2 * size_ + size_ - column];
            Energy* energy = &energy_[y * size_];
            for (std::size_t x = 0; x < size_; ++x) energy[x] += Sign * around[x];
        }
    }

    std::size_t size_;
    std::vector<std::uint8_t> dots_;
    std::vector<Energy> energy_, around_;
};

/// A tenth of the pixels, moved until they are spread evenly.
DotPattern even_pattern(int size, std::uint64_t seed, std::uint16_t& dots) {
    DotPattern pattern(size);
    Pcg32 random(seed);
    const auto pixels = static_cast<std::uint32_t>(size * size);
    dots = static_cast<std::uint16_t>(std::max(1u, kDotsInTen * pixels / 10));
    for (int i = 0; i < dots;) {
        const std::size_t pixel = random.next() % pixels;
        if (pattern.has(pixel)) continue;
        pattern.put(pixel);
        ++i;
    }
    while (true) {
        const std::size_t from = pattern.tightest_cluster();
        pattern.take(from);
        const std::size_t to = pattern.largest_void();
        pattern.put(to);
        if (to == from) return pattern;
    }
}

}  // namespace

std::vector<std::uint16_t> void_and_cluster(int size, std::uint64_t seed) {
    std::uint16_t dots = 0;
    const DotPattern even = even_pattern(size, seed, dots);
    std::vector<std::uint16_t> ranks(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));

    DotPattern pattern = even;
    for (int rank = dots - 1; rank >= 0; --rank) {
        const std::size_t pixel = pattern.tightest_cluster();
        pattern.take(pixel);
        ranks[pixel] = static_cast<std::uint16_t>(rank);
    }

    // Up to the last: where dots are the majority, the tightest cluster of the others is their largest void, as both
    // energies have the same sum everywhere.
    pattern = even;
    for (std::size_t rank = dots; rank < ranks.size(); ++rank) {
        const std::size_t pixel = pattern.largest_void();
        pattern.put(pixel);
        ranks[pixel] = static_cast<std::uint16_t>(rank);
    }
    return ranks;
}

}  // namespace emulsion
