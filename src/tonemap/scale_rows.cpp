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

/// LuminanceTable::operator() for a vector.
Vector look_up(const LuminanceTable::View& table, Vector x) noexcept {
    const hn::RebindToUnsigned<Floats> unsigned_tag;
    const hn::RebindToSigned<Floats> signed_tag;
    const Floats tag;
    auto bits = hn::BitCast(unsigned_tag, x);
    bits = hn::Min(hn::Max(bits, hn::Set(unsigned_tag, table.least_bits)), hn::Set(unsigned_tag, table.most_bits));
    const auto cell = hn::Sub(hn::ShiftRight<LuminanceTable::kShift>(bits), hn::Set(unsigned_tag, table.first_cell));
    const auto index = hn::BitCast(signed_tag, hn::ShiftLeft<1>(cell));
    const auto fraction_bits = hn::And(bits, hn::Set(unsigned_tag, LuminanceTable::kFractionBits));
    const auto fraction = hn::ConvertTo(tag, hn::BitCast(signed_tag, fraction_bits));
    const auto value = hn::GatherIndex(tag, table.cells, index);
    const auto slope = hn::GatherIndex(tag, table.cells + 1, index);
    return hn::Add(value, hn::Mul(fraction, slope));
}

/// out = scale_of(x, Y) * in, a vector of pixels from x on.
template <class ScaleOf>
void scale_vector(std::size_t x, const float* in, float* out, const ScaleOf& scale_of, std::size_t count,
                  const ExactPixel& exact) {
    const Floats tag;
    Vector px, py, pz;
    hn::LoadInterleaved3(tag, in, px, py, pz);
    const auto scale = scale_of(x, py);
    const auto limit = hn::Set(tag, static_cast<float>(kMaxDisplayComponent));
    const auto within = [&](Vector v) { return hn::Le(hn::Abs(v), limit); };
    const auto sx = hn::Mul(scale, px), sy = hn::Mul(scale, py), sz = hn::Mul(scale, pz);
    const auto plain = hn::And(hn::And(hn::Ge(py, hn::Zero(tag)), within(sx)), hn::And(within(sy), within(sz)));
    if (HWY_LIKELY(hn::AllTrue(tag, plain))) {
        hn::StoreInterleaved3(sx, sy, sz, tag, out);
        return;
    }
    constexpr std::size_t kMost = hn::MaxLanes(Floats());
    std::array<float, 3 * kMost> before;  // all of it that is read is set
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

template <class ScaleOf>
void scale_row_by(const ScaleOf& scale_of, const float* in, float* out, std::size_t size, const ExactPixel& exact) {
    const std::size_t lanes = hn::Lanes(Floats());
    std::size_t x = 0;
    for (; x + lanes <= size; x += lanes) scale_vector(x, in + 3 * x, out + 3 * x, scale_of, lanes, exact);
    if (x == size) return;
    std::array<float, 3 * hn::MaxLanes(Floats())> rest{};
    std::copy(in + 3 * x, in + 3 * size, rest.begin());
    scale_vector(x, rest.data(), rest.data(), scale_of, size - x, exact);
    std::copy(rest.data(), rest.data() + 3 * (size - x), out + 3 * x);
}

void by_constant(float scale, const float* in, float* out, std::size_t size, const ExactPixel& exact) {
    const Vector scales = hn::Set(Floats(), scale);
    scale_row_by([&](std::size_t, Vector) { return scales; }, in, out, size, exact);
}

void by_luminance(const LuminanceTable& table, const float* in, float* out, std::size_t size, const ExactPixel& exact) {
    const LuminanceTable::View view = table.view();
    scale_row_by([&](std::size_t, Vector luminance) { return look_up(view, luminance); }, in, out, size, exact);
}

/// adaptation[x ...], and beyond the row's end what is harmless.
Vector load(std::span<const float> adaptation, std::size_t x) noexcept {
    const Floats tag;
    if (x + hn::Lanes(tag) <= adaptation.size()) return hn::LoadU(tag, adaptation.data() + x);
    std::array<float, hn::MaxLanes(Floats())> rest{};
    std::copy(adaptation.begin() + static_cast<std::ptrdiff_t>(x), adaptation.end(), rest.begin());
    return hn::LoadU(tag, rest.data());
}

void by_adaptation(const LuminanceTable& table, std::span<const float> adaptation, const float* in, float* out,
                   const ExactPixel& exact) {
    const LuminanceTable::View view = table.view();
    const auto scale_of = [&](std::size_t x, Vector) { return look_up(view, load(adaptation, x)); };
    scale_row_by(scale_of, in, out, adaptation.size(), exact);
}

void by_both(const LuminanceTable& exposures, const LuminanceTable& compressions, std::span<const float> adaptation,
             const float* in, float* out, const ExactPixel& exact) {
    const LuminanceTable::View exposure_view = exposures.view(), compression_view = compressions.view();
    const auto scale_of = [&](std::size_t x, Vector luminance) {
        const auto exposure = look_up(exposure_view, load(adaptation, x));
        return hn::Mul(exposure, look_up(compression_view, hn::Mul(exposure, luminance)));
    };
    scale_row_by(scale_of, in, out, adaptation.size(), exact);
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
