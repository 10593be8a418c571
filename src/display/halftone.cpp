#include "display/halftone.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>

#include "display/threshold_rows.h"

namespace emulsion {

namespace {

/// The classical cells. The rank is how many pixels of the cell turn white before this one: high ranks come first.
constexpr std::array kCellOf2 = {0, 2, 3, 1};
constexpr std::array kCellOf3 = {6, 8, 4, 1, 0, 3, 5, 2, 7};
constexpr std::array kCellOf4 = {12, 5, 6, 13, 4, 0, 1, 7, 11, 3, 2, 8, 15, 10, 9, 14};

/// The rank of every pixel of an upright cell that has a classical order; none for others.
std::span<const int> classical_cell(const HalftoneCell& cell) noexcept {
    if (cell == HalftoneCell{2, 0}) return kCellOf2;
    if (cell == HalftoneCell{3, 0}) return kCellOf3;
    if (cell == HalftoneCell{4, 0}) return kCellOf4;
    return {};
}

/// Where a pixel lies in its cell: along its sides, in units of 1 / pixels() of them.
struct PlaceInCell {
    int u, v;
    auto operator<=>(const PlaceInCell&) const = default;
};
PlaceInCell place_in(const HalftoneCell& cell, int x, int y) noexcept {
    const int pixels = cell.pixels();
    const auto modulo = [&](int value) { return (value % pixels + pixels) % pixels; };
    return {modulo(cell.a * x + cell.b * y), modulo(-cell.b * x + cell.a * y)};
}

/// Squared distance from the middle of the cell at the corner of cells (0, 0), times pixels()^2.
int distance(const HalftoneCell& cell, const PlaceInCell& place) noexcept {
    const int pixels = cell.pixels(), u = std::min(place.u, pixels - place.u), v = std::min(place.v, pixels - place.v);
    return u * u + v * v;
}

/// The places of a cell by rank: by distance from the middle, and around it where that is the same.
std::vector<PlaceInCell> places_by_rank(const HalftoneCell& cell) {
    std::vector<PlaceInCell> places;
    for (int y = 0; y < cell.pixels(); ++y) {
        for (int x = 0; x < cell.pixels(); ++x) places.push_back(place_in(cell, x, y));
    }
    std::ranges::sort(places);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    std::ranges::stable_sort(places, {}, [&](const PlaceInCell& place) { return distance(cell, place); });
    return places;
}

}  // namespace

HalftoneCell halftone_cell(const Halftone& dither, int channel, int channels) {
    if (dither.screens == kUprightScreens) return {dither.size, 0};
    constexpr std::array kPlateAngles_deg = {15.0, 75.0, 0.0};
    const double angle_deg = channels == 1 ? 45.0 : kPlateAngles_deg.at(static_cast<std::size_t>(channel));
    const double angle = angle_deg * std::numbers::pi / 180.0;
    return {static_cast<int>(std::lround(dither.size * std::cos(angle))),
            static_cast<int>(std::lround(dither.size * std::sin(angle)))};
}

std::vector<int> halftone_ranks(const HalftoneCell& cell) {
    const int side = cell.pixels();
    const std::span<const int> classical = classical_cell(cell);
    const std::vector<PlaceInCell> places = places_by_rank(cell);
    const auto columns = static_cast<std::size_t>(cell.a);  // of a classical cell
    std::vector<int> ranks;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            if (!classical.empty()) {
                ranks.push_back(
                    classical[static_cast<std::size_t>(y % cell.a) * columns + static_cast<std::size_t>(x % cell.a)]);
                continue;
            }
            const auto found = std::ranges::find(places, place_in(cell, x, y));
            ranks.push_back(static_cast<int>(found - places.begin()));
        }
    }
    return ranks;
}

void quantize(const Halftone& dither, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
              int threads) {
    struct Screen {
        std::size_t side;
        std::vector<Threshold> thresholds;
    };
    std::vector<Screen> screens;
    for (int c = 0; c < source.channels(); ++c) {
        const HalftoneCell cell = halftone_cell(dither, c, source.channels());
        Screen screen{static_cast<std::size_t>(cell.pixels()), {}};
        for (const int rank : halftone_ranks(cell)) {
            screen.thresholds.push_back(threshold_of_rank(rank, cell.pixels()));
        }
        screens.push_back(std::move(screen));
    }
    const auto fill_row = [&](int y, std::span<Threshold> row) {
        for (std::size_t c = 0; c < screens.size(); ++c) {
            const Screen& screen = screens[c];
            const std::size_t begin = static_cast<std::size_t>(y) % screen.side * screen.side;
            std::size_t x = 0;
            for (std::size_t i = c; i < row.size(); i += screens.size()) {
                row[i] = screen.thresholds[begin + x];
                x = x + 1 == screen.side ? 0 : x + 1;
            }
        }
    };
    quantize_by_thresholds(source, scale, codes, threads, source.width(), fill_row);
}

}  // namespace emulsion
