#include "display/hilbert_curve.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include "core/image.h"

namespace emulsion {
namespace {

// The first curve, by hand: down, right, up.
TEST(HilbertCurve, OfTwoByTwo) {
    EXPECT_EQ(hilbert_curve(2, 2), (std::vector<PixelPlace>{{0, 0}, {0, 1}, {1, 1}, {1, 0}}));
}

TEST(HilbertCurve, VisitsEveryPixelOnceFromNeighbourToNeighbour) {
    int steps = 0, corners = 0;
    for (int height = 1; height <= 40; ++height) {
        for (int width = 1; width <= 40; ++width) {
            const std::vector<PixelPlace> curve = hilbert_curve(width, height);
            Image<std::uint8_t> visits(width, height);
            for (const PixelPlace& p : curve) ++visits(p.x, p.y);
            EXPECT_TRUE(std::ranges::all_of(visits.pixels(), [](int n) { return n == 1; })) << width << "x" << height;
            EXPECT_EQ(curve.front(), (PixelPlace{0, 0}));
            int corners_here = 0;
            for (std::size_t i = 1; i < curve.size(); ++i) {
                const int dx = std::abs(curve[i].x - curve[i - 1].x), dy = std::abs(curve[i].y - curve[i - 1].y);
                ASSERT_EQ(std::max(dx, dy), 1) << width << "x" << height << ", step " << i;
                corners_here += dx == 1 && dy == 1 ? 1 : 0;
                ++steps;
            }
            corners += corners_here;
            EXPECT_LE(corners_here, 1) << width << "x" << height;
        }
    }
    EXPECT_GT(steps, 600000);
    EXPECT_GT(corners, 0);
}

// It stays near: of 256 x 256, any 64 pixels in a row on it lie in a square of 16.
TEST(HilbertCurve, StaysNear) {
    const std::vector<PixelPlace> curve = hilbert_curve(256, 256);
    for (std::size_t i = 0; i + 64 <= curve.size(); i += 64) {
        int x0 = 256, x1 = 0, y0 = 256, y1 = 0;
        for (std::size_t k = i; k < i + 64; ++k) {
            x0 = std::min(x0, curve[k].x), x1 = std::max(x1, curve[k].x);
            y0 = std::min(y0, curve[k].y), y1 = std::max(y1, curve[k].y);
        }
        ASSERT_LE(std::max(x1 - x0, y1 - y0), 16) << i;
    }
}

}  // namespace
}  // namespace emulsion
