#include "display/hilbert_curve.h"

#include <cstddef>
#include <cstdlib>

namespace emulsion {

namespace {

/// A vector along an axis.
struct Side {
    int x, y;
    [[nodiscard]] int length() const noexcept { return std::abs(x + y); }
    [[nodiscard]] Side unit() const noexcept { return {(x > 0) - (x < 0), (y > 0) - (y < 0)}; }
};
Side operator+(Side a, Side b) noexcept { return {a.x + b.x, a.y + b.y}; }
Side operator-(Side a, Side b) noexcept { return {a.x - b.x, a.y - b.y}; }
Side operator-(Side a) noexcept { return {-a.x, -a.y}; }
PixelPlace operator+(PixelPlace p, Side s) noexcept { return {p.x + s.x, p.y + s.y}; }

/// Half of a side, as an even number of pixels where it has more than two, since odd halves make diagonal steps.
Side half(Side side) noexcept {
    const Side whole = {side.x / 2, side.y / 2};
    return whole.length() % 2 != 0 && side.length() > 2 ? whole + side.unit() : whole;
}

void add_line(PixelPlace from, Side along, std::vector<PixelPlace>& curve) {
    for (int i = 0; i < along.length(); ++i, from = from + along.unit()) curve.push_back(from);
}

/// The rectangle with a corner at `from` and the sides `along` and `across`; the curve ends at the far end of `along`.
void add_rectangle(PixelPlace from, Side along, Side across, std::vector<PixelPlace>& curve) {
    if (across.length() == 1) return add_line(from, along, curve);
    if (along.length() == 1) return add_line(from, across, curve);

    if (2 * along.length() > 3 * across.length()) {
        const Side first = half(along);
        add_rectangle(from, first, across, curve);
        add_rectangle(from + first, along - first, across, curve);
        return;
    }
    // Up, along and down again
    const Side first = {along.x / 2, along.y / 2}, up = half(across);
    add_rectangle(from, up, first, curve);
    add_rectangle(from + up, along, across - up, curve);
    add_rectangle(from + (along - along.unit()) + (up - up.unit()), -up, first - along, curve);
}

}  // namespace

std::vector<PixelPlace> hilbert_curve(int width, int height) {
    std::vector<PixelPlace> curve;
    curve.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const Side right = {width, 0}, down = {0, height};
    if (width >= height) {
        add_rectangle({0, 0}, right, down, curve);
    } else {
        add_rectangle({0, 0}, down, right, curve);
    }
    return curve;
}

}  // namespace emulsion
