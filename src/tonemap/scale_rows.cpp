#include "tonemap/scale_rows.h"

#include <algorithm>
#include <array>

#include "tonemap/scale_pixels.h"

// Compiled once for each instruction set; which of them runs is decided when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tonemap/scale_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace emulsion::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::ScalableTag<float>;
using Vector = hn::Vec<Floats>;

/// Rows are worked off in blocks: what one step leaves behind is still in the cache for the next.
constexpr std::size_t kBlock = 256;
using Block = std::array<float, kBlock + hn::MaxLanes(Floats())>;

/// results[i] = table(keys[i]) for i < count; LuminanceTable::View says how.
void look_up(const LuminanceTable::View& table, const float* keys, std::size_t count, float* results) {
    const hn::RebindToUnsigned<Floats> unsigned_tag;
    const hn::RebindToSigned<Floats> signed_tag;
    const Floats tag;
    const std::size_t lanes = hn::Lanes(tag);
    const auto bits_of = [&](std::size_t i) {
        const auto bits = hn::BitCast(unsigned_tag, hn::LoadU(tag, keys + i));
        return hn::Min(hn::Max(bits, hn::Set(unsigned_tag, table.least_bits)), hn::Set(unsigned_tag, table.most_bits));
    };
    std::array<std::uint32_t, kBlock + hn::MaxLanes(Floats())> cells{};
    for (std::size_t i = 0; i < count; i += lanes) {
        const auto cell = hn::ShiftRight<LuminanceTable::kShift>(bits_of(i));
        hn::StoreU(hn::Sub(cell, hn::Set(unsigned_tag, table.first_cell)), unsigned_tag, cells.data() + i);
    }
    std::array<LuminanceTable::Cell, kBlock + hn::MaxLanes(Floats())> found;
    for (std::size_t i = 0; i < count; ++i) found[i] = table.cells[cells[i]];
    for (std::size_t i = 0; i < count; i += lanes) {
        Vector value, slope;
        hn::LoadInterleaved2(tag, &found[i].value, value, slope);
        const auto fraction_bits = hn::And(bits_of(i), hn::Set(unsigned_tag, LuminanceTable::kFractionBits));
        const auto fraction = hn::ConvertTo(tag, hn::BitCast(signed_tag, fraction_bits));
        hn::StoreU(hn::Add(value, hn::Mul(fraction, slope)), tag, results + i);
    }
}

/// out = scale_of(x) * in, a vector of pixels from x on, `count` of which belong to the row.
template <class ScaleOf>
void scale_vector(std::size_t x, const float* in, float* out, const ScaleOf& scale_of, std::size_t count,
                  const ExactPixel& exact) {
    const Floats tag;
    Vector px, py, pz;
    hn::LoadInterleaved3(tag, in, px, py, pz);
    const auto scale = scale_of(x);
    const auto limit = hn::Set(tag, static_cast<float>(kMaxDisplayComponent));
    const auto within = [&](Vector v) { return hn::Le(hn::Abs(v), limit); };
    const auto sx = hn::Mul(scale, px), sy = hn::Mul(scale, py), sz = hn::Mul(scale, pz);
    const auto plain = hn::And(hn::And(hn::Ge(py, hn::Zero(tag)), within(sx)), hn::And(within(sy), within(sz)));
    if (HWY_LIKELY(hn::AllTrue(tag, plain))) {
        hn::StoreInterleaved3(sx, sy, sz, tag, out);
        return;
    }
    constexpr std::size_t kMost = hn::MaxLanes(Floats());
    std::array<float, 3 * kMost> before{};
    std::array<std::uint8_t, (kMost + 7) / 8 + 8> is_plain{};
    hn::StoreInterleaved3(px, py, pz, tag, before.data());
    hn::StoreInterleaved3(sx, sy, sz, tag, out);
    hn::StoreMaskBits(tag, plain, is_plain.data());
    for (std::size_t i = 0; i < count; ++i) {
        if ((is_plain[i / 8] >> (i % 8) & 1) != 0) continue;
        const XYZ replaced = exact(x + i, {before[3 * i], before[3 * i + 1], before[3 * i + 2]});
        out[3 * i] = replaced.x;
        out[3 * i + 1] = replaced.y;
        out[3 * i + 2] = replaced.z;
    }
}

/// Fewer pixels than a vector has lanes.
template <class ScaleOf>
void scale_rest(std::size_t x, const float* in, float* out, std::size_t count, const ScaleOf& scale_of,
                const ExactPixel& exact) {
    std::array<float, 3 * hn::MaxLanes(Floats())> rest{};
    std::copy(in, in + 3 * count, rest.begin());
    scale_vector(x, rest.data(), rest.data(), scale_of, count, exact);
    std::copy(rest.data(), rest.data() + 3 * count, out);
}

/// `scale_of(x)` gives the scales of the pixels from x on, of which there are `end` in the row.
template <class ScaleOf>
void scale_pixels_between(std::size_t begin, std::size_t end, const float* in, float* out, const ScaleOf& scale_of,
                          const ExactPixel& exact) {
    const std::size_t lanes = hn::Lanes(Floats());
    std::size_t x = begin;
    for (; x + lanes <= end; x += lanes) scale_vector(x, in + 3 * x, out + 3 * x, scale_of, lanes, exact);
    if (x < end) scale_rest(x, in + 3 * x, out + 3 * x, end - x, scale_of, exact);
}

/// Y of `count` pixels.
void take_luminances(const float* in, std::size_t count, float* luminances) {
    const Floats tag;
    const std::size_t lanes = hn::Lanes(tag);
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) {
        Vector x, y, z;
        hn::LoadInterleaved3(tag, in + 3 * i, x, y, z);
        hn::StoreU(y, tag, luminances + i);
    }
    for (; i < count; ++i) luminances[i] = in[3 * i + 1];
}

/// Block by block: `find_scales(x, count, scales)` fills in those of `count` pixels from x on.
template <class FindScales>
void scale_blocks(const float* in, float* out, std::size_t size, const FindScales& find_scales,
                  const ExactPixel& exact) {
    Block scales{};
    for (std::size_t begin = 0; begin < size; begin += kBlock) {
        const std::size_t end = std::min(begin + kBlock, size);
        find_scales(begin, end - begin, scales.data());
        const auto scale_of = [&](std::size_t x) { return hn::LoadU(Floats(), scales.data() + (x - begin)); };
        scale_pixels_between(begin, end, in, out, scale_of, exact);
    }
}

void by_constant(float scale, const float* in, float* out, std::size_t size, const ExactPixel& exact) {
    const Vector scales = hn::Set(Floats(), scale);
    scale_pixels_between(
        0, size, in, out, [&](std::size_t) { return scales; }, exact);
}

void by_luminance(const LuminanceTable& table, const float* in, float* out, std::size_t size, const ExactPixel& exact) {
    Block luminances{};
    const auto find_scales = [&](std::size_t x, std::size_t count, float* scales) {
        take_luminances(in + 3 * x, count, luminances.data());
        look_up(table.view(), luminances.data(), count, scales);
    };
    scale_blocks(in, out, size, find_scales, exact);
}

void by_adaptation(const LuminanceTable& table, std::span<const float> adaptation, const float* in, float* out,
                   const ExactPixel& exact) {
    Block keys{};
    const auto find_scales = [&](std::size_t x, std::size_t count, float* scales) {
        std::copy_n(adaptation.data() + x, count, keys.data());
        look_up(table.view(), keys.data(), count, scales);
    };
    scale_blocks(in, out, adaptation.size(), find_scales, exact);
}

void by_both(const LuminanceTable& exposures, const LuminanceTable& compressions, std::span<const float> adaptation,
             const float* in, float* out, const ExactPixel& exact) {
    Block keys{}, found{};
    const auto find_scales = [&](std::size_t x, std::size_t count, float* scales) {
        std::copy_n(adaptation.data() + x, count, keys.data());
        look_up(exposures.view(), keys.data(), count, found.data());
        take_luminances(in + 3 * x, count, keys.data());
        for (std::size_t i = 0; i < count; ++i) keys[i] *= found[i];
        look_up(compressions.view(), keys.data(), count, scales);
        for (std::size_t i = 0; i < count; ++i) scales[i] *= found[i];
    };
    scale_blocks(in, out, adaptation.size(), find_scales, exact);
}

}  // namespace emulsion::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace emulsion {

namespace {

HWY_EXPORT(by_constant);
HWY_EXPORT(by_luminance);
HWY_EXPORT(by_adaptation);
HWY_EXPORT(by_both);

static_assert(sizeof(XYZ) == 3 * sizeof(float));
const float* floats_of(std::span<const XYZ> row) noexcept { return &row.data()->x; }
float* floats_of(std::span<XYZ> row) noexcept { return &row.data()->x; }

}  // namespace

void scale_row(float scale, std::span<const XYZ> in, std::span<XYZ> out, const ExactPixel& exact) {
    HWY_DYNAMIC_DISPATCH(by_constant)(scale, floats_of(in), floats_of(out), in.size(), exact);
}

void scale_row(const LuminanceTable& table, std::span<const XYZ> in, std::span<XYZ> out, const ExactPixel& exact) {
    HWY_DYNAMIC_DISPATCH(by_luminance)(table, floats_of(in), floats_of(out), in.size(), exact);
}

void scale_row(const LuminanceTable& table, std::span<const float> adaptation, std::span<const XYZ> in,
               std::span<XYZ> out, const ExactPixel& exact) {
    HWY_DYNAMIC_DISPATCH(by_adaptation)(table, adaptation, floats_of(in), floats_of(out), exact);
}

void scale_row(const LuminanceTable& exposures, const LuminanceTable& compressions, std::span<const float> adaptation,
               std::span<const XYZ> in, std::span<XYZ> out, const ExactPixel& exact) {
    HWY_DYNAMIC_DISPATCH(by_both)(exposures, compressions, adaptation, floats_of(in), floats_of(out), exact);
}

}  // namespace emulsion
#endif
