#include "tonemap/bilateral_rows.h"

#include <algorithm>
#include <array>

// Compiled once for each instruction set; which of them runs is decided when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tonemap/bilateral_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/vector_loop.h"

HWY_BEFORE_NAMESPACE();
namespace emulsion::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

PositiveRange range(const float* values, std::size_t count) {
    PositiveRange range;
    for_each_vector(count, [&](auto tag, std::size_t i) HWY_ATTR {
        const auto value = hn::LoadU(tag, values + i), infinity = hn::Set(tag, range.least);
        const auto positive = hn::IfThenElse(hn::Gt(value, hn::Zero(tag)), value, infinity);
        range.least = std::min(range.least, hn::GetLane(hn::MinOfLanes(tag, positive)));
        range.most = std::max(range.most, hn::GetLane(hn::MaxOfLanes(tag, value)));
    });
    return range;
}

/// coefficients[0] + x (coefficients[1] + x (...)), without fused operations.
template <class Tag, std::size_t Count>
HWY_INLINE hn::Vec<Tag> polynomial(Tag tag, hn::Vec<Tag> x, const std::array<float, Count>& coefficients) {
    auto sum = hn::Set(tag, coefficients[Count - 1]);
    for (std::size_t i = Count - 1; i-- > 0;) sum = hn::Add(hn::Set(tag, coefficients[i]), hn::Mul(x, sum));
    return sum;
}

/// log2 of normal numbers: the exponent of the power of two next to x, and log2 m = 2 / ln 2 artanh((m - 1) / (m + 1))
/// of the rest m, in [sqrt(1/2), sqrt(2)), by its series.
template <class Tag>
HWY_INLINE hn::Vec<Tag> log2_of(Tag tag, hn::Vec<Tag> x) {
    constexpr double kScale = 2.0 * 1.4426950408889634;
    constexpr std::array kSeries = {static_cast<float>(kScale), static_cast<float>(kScale / 3.0),
                                    static_cast<float>(kScale / 5.0), static_cast<float>(kScale / 7.0),
                                    static_cast<float>(kScale / 9.0)};
    constexpr std::int32_t kRootOfHalf = 0x3f3504f3;
    const hn::RebindToSigned<Tag> integers;
    const auto bits = hn::BitCast(integers, x);
    const auto exponent = hn::ShiftRight<23>(hn::Sub(bits, hn::Set(integers, kRootOfHalf)));
    const auto rest = hn::BitCast(tag, hn::Sub(bits, hn::ShiftLeft<23>(exponent))), one = hn::Set(tag, 1.0f);
    const auto s = hn::Div(hn::Sub(rest, one), hn::Add(rest, one));
    return hn::Add(hn::ConvertTo(tag, exponent), hn::Mul(s, polynomial(tag, hn::Mul(s, s), kSeries)));
}

/// 2^x for x in [-125.5, 127): of the integer next to x by the exponent, of the rest, in [-1/2, 1/2], by its series.
template <class Tag>
HWY_INLINE hn::Vec<Tag> exp2_of(Tag tag, hn::Vec<Tag> x) {
    constexpr std::array kSeries = {1.0f,           0.693147181f,   0.240226507f,   0.0555041087f,
                                    0.00961812911f, 0.00133335581f, 0.000154035304f};
    const hn::RebindToSigned<Tag> integers;
    const auto whole = hn::Round(x);
    const auto factor = polynomial(tag, hn::Sub(x, whole), kSeries);
    return hn::BitCast(tag, hn::Add(hn::BitCast(integers, factor), hn::ShiftLeft<23>(hn::ConvertTo(integers, whole))));
}

void take_logarithms(float least, float* values, std::size_t count) {
    for_each_vector(count, [&](auto tag, std::size_t i) HWY_ATTR {
        hn::StoreU(log2_of(tag, hn::Max(hn::LoadU(tag, values + i), hn::Set(tag, least))), tag, values + i);
    });
}

/// Rows are worked off in blocks: what one step leaves behind is still in the cache for the next.
constexpr std::size_t kBlock = 256;

struct Places {
    std::array<float, kBlock> place{};          ///< in steps above the lowest level
    std::array<float, kBlock> up{};             ///< how far from the level below towards that above
    std::array<std::uint32_t, kBlock> level{};  ///< below
};

void find_places(const GridLevels& levels, const float* values, std::size_t count, Places& places) {
    for_each_vector(count, [&](auto tag, std::size_t i) HWY_ATTR {
        const hn::RebindToSigned<decltype(tag)> integers;
        const auto above = hn::Sub(hn::LoadU(tag, values + i), hn::Set(tag, levels.least));
        const auto place = hn::Max(hn::Div(above, hn::Set(tag, levels.step)), hn::Zero(tag));
        const auto last = hn::Set(integers, static_cast<std::int32_t>(levels.count) - 2);
        const auto level = hn::Min(hn::ConvertTo(integers, place), last);
        hn::StoreU(place, tag, places.place.data() + i);
        hn::StoreU(hn::Sub(place, hn::ConvertTo(tag, level)), tag, places.up.data() + i);
        const hn::RebindToUnsigned<decltype(tag)> unsigned_tag;
        hn::StoreU(hn::BitCast(unsigned_tag, level), unsigned_tag, places.level.data() + i);
    });
}

void spread(const GridLevels& levels, const GridColumns& columns, float below, const float* values, std::size_t count,
            float* cells) {
    using Sums = hn::CappedTag<float, kCellSums>;
    const Sums tag;
    constexpr std::array<float, kCellSums> kForWeight = {1, 0, 1, 0, 1, 0, 1, 0}, kForPlace = {0, 1, 0, 1, 0, 1, 0, 1};
    const float above = 1.0f - below;
    const std::array<float, kCellSums> down = {above, above, above, above, below, below, below, below};
    Places places;
    for (std::size_t begin = 0; begin < count; begin += kBlock) {
        const std::size_t size = std::min(kBlock, count - begin);
        find_places(levels, values + begin, size, places);
        for (std::size_t i = 0; i < size; ++i) {
            const std::size_t x = begin + i;
            float* const to = cells + columns.cell_offset[x] + kCellSums * std::size_t{places.level[i]};
            const auto place = hn::Set(tag, places.place[i]), up = hn::Set(tag, places.up[i]);
            for (std::size_t k = 0; k < kCellSums; k += hn::Lanes(tag)) {
                const auto across = hn::LoadDup128(tag, columns.across + 4 * x + k % 4);  // four, again and again
                const auto factor = hn::Add(hn::LoadU(tag, kForWeight.data() + k),
                                            hn::Mul(place, hn::LoadU(tag, kForPlace.data() + k)));
                const auto sums = hn::Mul(hn::Mul(across, hn::LoadU(tag, down.data() + k)), factor);
                const auto upper = hn::Mul(up, sums), lower = hn::Sub(sums, upper);
                hn::StoreU(hn::Add(hn::LoadU(tag, to + k), lower), tag, to + k);
                hn::StoreU(hn::Add(hn::LoadU(tag, to + kCellSums + k), upper), tag, to + kCellSums + k);
            }
        }
    }
}

/// Sums of the levels about each pixel's place: both of the lower one, then both of the upper one.
using FoundSums = std::array<float, 2 * kGridSums * kBlock>;

void average(const GridLevels& levels, const FoundSums& found, const Places& places, std::size_t count, float* values) {
    for_each_vector(count, [&](auto tag, std::size_t i) HWY_ATTR {
        auto weight = hn::Zero(tag), sum = weight, upper_weight = weight, upper_sum = weight;
        hn::LoadInterleaved4(tag, found.data() + 2 * kGridSums * i, weight, sum, upper_weight, upper_sum);
        const auto up = hn::LoadU(tag, places.up.data() + i), down = hn::Sub(hn::Set(tag, 1.0f), up);
        weight = hn::Add(hn::Mul(down, weight), hn::Mul(up, upper_weight));
        sum = hn::Add(hn::Mul(down, sum), hn::Mul(up, upper_sum));
        const auto above = hn::Mul(hn::Set(tag, levels.step), hn::Div(sum, weight));
        const auto logarithm = hn::Add(hn::Set(tag, levels.least), above);
        hn::StoreU(exp2_of(tag, hn::Max(logarithm, hn::Set(tag, -125.5f))), tag, values + i);
    });
}

void read(const GridLevels& levels, const GridColumns& columns, const float* nodes, float* values, std::size_t count) {
    using Sums = hn::CappedTag<float, 2 * kGridSums>;
    const Sums tag;
    Places places;
    FoundSums found{};
    for (std::size_t begin = 0; begin < count; begin += kBlock) {
        const std::size_t size = std::min(kBlock, count - begin);
        find_places(levels, values + begin, size, places);
        for (std::size_t i = 0; i < size; ++i) {
            const std::size_t x = begin + i, level = kGridSums * std::size_t{places.level[i]};
            const float *const left = nodes + columns.left[x] + level, *const right = nodes + columns.right[x] + level;
            const auto from_left = hn::Set(tag, columns.across[4 * x]),
                       from_right = hn::Set(tag, columns.across[4 * x + 2]);
            for (std::size_t k = 0; k < 2 * kGridSums; k += hn::Lanes(tag)) {
                const auto sums = hn::Add(hn::Mul(from_left, hn::LoadU(tag, left + k)),
                                          hn::Mul(from_right, hn::LoadU(tag, right + k)));
                hn::StoreU(sums, tag, found.data() + 2 * kGridSums * i + k);
            }
        }
        average(levels, found, places, size, values + begin);
    }
}

}  // namespace emulsion::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace emulsion {

namespace {

HWY_EXPORT(range);
HWY_EXPORT(take_logarithms);
HWY_EXPORT(spread);
HWY_EXPORT(read);

}  // namespace

PositiveRange positive_range(std::span<const float> row) { return HWY_DYNAMIC_DISPATCH(range)(row.data(), row.size()); }

void log2_row(float least, std::span<float> row) {
    constexpr float kLeastNormal = std::numeric_limits<float>::min();
    HWY_DYNAMIC_DISPATCH(take_logarithms)(std::max(least, kLeastNormal), row.data(), row.size());
}

void spread_row(const GridLevels& levels, const GridColumns& columns, float below, std::span<const float> row,
                float* cells) {
    HWY_DYNAMIC_DISPATCH(spread)(levels, columns, below, row.data(), row.size(), cells);
}

void read_row(const GridLevels& levels, const GridColumns& columns, const float* nodes, std::span<float> row) {
    HWY_DYNAMIC_DISPATCH(read)(levels, columns, nodes, row.data(), row.size());
}

}  // namespace emulsion
#endif
