#include "display/diffusion_kernel.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace emulsion {
namespace {

constexpr std::array kKernels = {kFloydSteinbergKernel, kJarvisKernel, kStuckiKernel, kSierraKernel, kAtkinsonKernel};

TEST(DiffusionKernel, TotalsAreThoseOfTheSources) {
    EXPECT_EQ(kFloydSteinbergKernel.total(), 16);
    EXPECT_EQ(kJarvisKernel.total(), 48);
    EXPECT_EQ(kStuckiKernel.total(), 42);
    EXPECT_EQ(kSierraKernel.total(), 32);
    EXPECT_EQ(kAtkinsonKernel.total(), 6);
    EXPECT_EQ(kAtkinsonKernel.divisor, 8);
    for (const DiffusionKernel& kernel : kKernels) {
        for (int dx = -2; dx <= 0; ++dx) EXPECT_EQ(kernel.weight(dx, 0), 0);
        if (kernel.reach() == 1) continue;  // the others are as wide to the left as to the right
        for (int dx = 1; dx <= 2; ++dx) {
            for (int dy = 1; dy <= 2; ++dy) EXPECT_EQ(kernel.weight(dx, dy), kernel.weight(-dx, dy));
        }
    }
}

TEST(DiffusionKernel, FloorQuotientRoundsDown) {
    for (const DiffusionKernel& kernel : kKernels) {
        for (int error = -100; error <= 100; ++error) {
            const int quotient = kernel.floor_quotient(error);
            EXPECT_LE(quotient * kernel.divisor, error);
            EXPECT_GT((quotient + 1) * kernel.divisor, error);
        }
    }
}

// An error that divides evenly gives every neighbour its weight of it.
TEST(DiffusionNeighbours, InsideSharesAreTheWeights) {
    for (const DiffusionKernel& kernel : kKernels) {
        const DiffusionNeighbours inside(kernel, 2, 2, 2);
        int neighbours = 0;
        inside.hand_on(kernel, 1000 * kernel.divisor, [&](int dx, int dy, int share) {
            EXPECT_EQ(share, 1000 * kernel.weight(dx, dy)) << dx << ", " << dy;
            ++neighbours;
        });
        EXPECT_EQ(neighbours, kernel.reach() == 1 ? 4 : kernel.total() == 6 ? 6 : kernel.total() == 32 ? 10 : 12);
    }
}

// At every place in the picture: all is handed on (of Atkinson's kernel 3/4, rounded down), to pixels inside, and
// nearly in proportion to the weights.
TEST(DiffusionNeighbours, NothingIsLostBetweenNeighbours) {
    for (const DiffusionKernel& kernel : kKernels) {
        for (int place = 0; place < 27; ++place) {
            const int behind = place % 3, ahead = place / 3 % 3, below = place / 9;
            const DiffusionNeighbours neighbours(kernel, behind, ahead, below);
            int total = 0;
            for (int dy = 0; dy <= below; ++dy) {
                for (int dx = -behind; dx <= ahead; ++dx) total += kernel.weight(dx, dy);
            }
            for (const std::int64_t error : {-40000, -77, -1, 0, 1, 5, 1001, 32768}) {
                std::int64_t sum = 0;
                neighbours.hand_on(kernel, error, [&](int dx, int dy, std::int64_t share) {
                    EXPECT_TRUE(-dx <= behind && dx <= ahead && dy <= below);
                    const double exact =
                        static_cast<double>(error * kernel.total()) / kernel.divisor * kernel.weight(dx, dy) / total;
                    EXPECT_NEAR(static_cast<double>(share), exact, kernel.divisor);
                    sum += share;
                });
                EXPECT_EQ(sum, total == 0 ? 0 : kernel.handed_on(error));
            }
        }
    }
}

/// How large an error may be after so many rows, in codes: that of a pixel is at most half a code, or what has reached
/// it if there is no code to make that good. Here it always is the larger of the two, with all errors of one sign.
double largest_error(const DiffusionKernel& kernel, int width, int height) {
    std::vector<std::vector<double>> rows(3, std::vector<double>(static_cast<std::size_t>(width)));
    const auto row = [&](int y) -> std::vector<double>& { return rows[static_cast<std::size_t>(y % 3)]; };
    double largest = 0.0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double error = std::max(0.5, row(y)[static_cast<std::size_t>(x)]);
            largest = std::max(largest, error);
            const int left = std::max(-2, -x), right = std::min(2, width - 1 - x);
            int total = 0;
            for (int dy = 0; dy <= 2; ++dy) {
                for (int dx = left; dx <= right; ++dx) total += kernel.weight(dx, dy);
            }
            const double handed = error * kernel.total() / kernel.divisor;
            for (int dy = 0; dy <= 2; ++dy) {
                for (int dx = left; dx <= right; ++dx) {
                    row(y + dy)[static_cast<std::size_t>(x + dx)] += handed * kernel.weight(dx, dy) / total;
                }
            }
        }
        std::ranges::fill(row(y), 0.0);
    }
    return largest;
}

// Errors that find no code drift to the right border: a part that is white there takes what comes from the left row by
// row. Fewer than 0.12 codes a row, for all kernels; 32 bits hold so many rows of them (kMostErrorRows of
// error_rows.h).
TEST(DiffusionNeighbours, ErrorsGrowSlowly) {
    for (const DiffusionKernel& kernel : kKernels) {
        for (const int width : {8, 9, 16, 64}) {
            const double after_2000 = largest_error(kernel, width, 2000);
            EXPECT_LT(after_2000, 0.12 * 2000.0) << kernel.divisor << ", " << width;
            EXPECT_LT(largest_error(kernel, width, 4000) - after_2000, 0.12 * 2000.0);
        }
    }
    EXPECT_NEAR(largest_error(kFloydSteinbergKernel, 64, 2000), 228.0, 3.0);
    EXPECT_LT(largest_error(kAtkinsonKernel, 64, 2000), 1.0);
}

}  // namespace
}  // namespace emulsion
