#include "tonemap/scale_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

// Compiled once for each instruction set; which of them runs is decided when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tonemap/scale_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "tonemap/pixel_vectors.h"

HWY_BEFORE_NAMESPACE();
namespace emulsion::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// LuminanceTable for a vector of luminances; LuminanceTable::View says how.
class VectorTable {
  public:
    explicit VectorTable(const LuminanceTable::View& table)
        : cells_(table.cells),
          first_cell_(hn::Set(hn::RebindToUnsigned<Floats>(), table.first_cell)),
          least_bits_(hn::Set(hn::RebindToUnsigned<Floats>(), table.least_bits)),
          most_bits_(hn::Set(hn::RebindToUnsigned<Floats>(), table.most_bits)) {}

    [[nodiscard]] Vector operator()(Vector luminances) const {
        const Floats tag;
        const hn::RebindToUnsigned<Floats> unsigned_tag;
        const hn::RebindToSigned<Floats> signed_tag;
        const auto bits = hn::Min(hn::Max(hn::BitCast(unsigned_tag, luminances), least_bits_), most_bits_);
        const auto cells = hn::BitCast(signed_tag, hn::Sub(hn::ShiftRight<LuminanceTable::kShift>(bits), first_cell_));
        const auto lower = gather(hn::LowerHalf(cells));
        const auto upper = gather(hn::UpperHalf(hn::Half<decltype(signed_tag)>(), cells));
        const auto fraction_bits = hn::And(bits, hn::Set(unsigned_tag, LuminanceTable::kFractionBits));
        const auto fraction = hn::ConvertTo(tag, hn::BitCast(signed_tag, fraction_bits));
        // A cell is a value and a slope.
        return hn::Add(hn::ConcatEven(tag, upper, lower), hn::Mul(fraction, hn::ConcatOdd(tag, upper, lower)));
    }

  private:
    using Bits = hn::Vec<hn::RebindToUnsigned<Floats>>;
    using Cells = hn::Repartition<std::int64_t, Floats>;

    template <class HalfOfCells>
    [[nodiscard]] Vector gather(HalfOfCells cells) const {
        return hn::BitCast(Floats(), hn::GatherIndex(Cells(), cells_, hn::PromoteTo(Cells(), cells)));
    }

    const std::int64_t* cells_;
    Bits first_cell_, least_bits_, most_bits_;
};

/// One pixel: of those that do not fill a vector, or that have others to be left beside them.
void scale_pixel(float scale, std::size_t x, const float* in, float* out, LeftPixels& left) {
    constexpr auto kLimit = static_cast<float>(kMaxDisplayComponent);
    const float* const pixel = in + 3 * x;
    const std::array<float, 3> scaled = {scale * pixel[0], scale * pixel[1], scale * pixel[2]};
    bool plain = pixel[1] >= 0.0f;
    for (const float component : scaled) plain = plain && std::abs(component) <= kLimit;
    if (!plain) left.push_back(x);
    std::copy_n(plain ? scaled.data() : pixel, 3, out + 3 * x);
}

/// Vectors of pixels from x on, up to the first that has a pixel to be left, or that would be past the end. Returns
/// where that one begins. No calls are in this loop, so that its constants stay in registers.
template <RowPixels Known, class ScaleOf>
std::size_t scale_vectors(std::size_t x, std::size_t size, const float* in, float* out, const ScaleOf& scale_of) {
    const Floats tag;
    const std::size_t lanes = hn::Lanes(tag);
    const PixelLanes pixel_lanes;
    for (; x + lanes <= size; x += lanes) {
        const PixelVectors pixels(in + 3 * x);
        const auto luminances = pixel_lanes.luminances(pixels);
        const PixelVectors scales = pixel_lanes.repeated(scale_of(x, luminances));
        const auto a = hn::Mul(pixels.a, scales.a), b = hn::Mul(pixels.b, scales.b), c = hn::Mul(pixels.c, scales.c);
        if constexpr (Known == RowPixels::any) {
            const auto limit = hn::Set(tag, static_cast<float>(kMaxDisplayComponent));
            const auto within = [&](Vector v) { return hn::Le(hn::Abs(v), limit); };
            const auto not_negative = hn::Ge(luminances, hn::Zero(tag));
            if (!hn::AllTrue(tag, hn::And(hn::And(not_negative, within(a)), hn::And(within(b), within(c))))) break;
        }
        hn::StoreU(a, tag, out + 3 * x);
        hn::StoreU(b, tag, out + 3 * x + lanes);
        hn::StoreU(c, tag, out + 3 * x + 2 * lanes);
    }
    return x;
}

/// out = scale_of(x, Y) * in. `scale_of` takes vectors, and floats.
template <class ScaleOf>
void scale_all(std::span<const XYZ> row, std::span<XYZ> scaled_row, const ScaleOf& scale_of, RowPixels pixels,
               LeftPixels& left) {
    static_assert(sizeof(XYZ) == 3 * sizeof(float));
    const float* const in = &row.data()->x;
    float* const out = &scaled_row.data()->x;
    for (std::size_t x = 0; x < row.size();) {
        x = pixels == RowPixels::plain ? scale_vectors<RowPixels::plain>(x, row.size(), in, out, scale_of)
                                       : scale_vectors<RowPixels::any>(x, row.size(), in, out, scale_of);
        const std::size_t end = std::min(x + hn::Lanes(Floats()), row.size());
        for (; x < end; ++x) scale_pixel(scale_of(x, row[x].y), x, in, out, left);
    }
}

/// The scale is the same for all, a function of Y, of the adaptation, or of both.
class ByConstant {
  public:
    explicit ByConstant(float scale) : scale_(scale), scales_(hn::Set(Floats(), scale)) {}
    [[nodiscard]] Vector operator()(std::size_t, Vector) const { return scales_; }
    [[nodiscard]] float operator()(std::size_t, float) const { return scale_; }

  private:
    float scale_;
    Vector scales_;
};

class ByLuminance {
  public:
    explicit ByLuminance(const LuminanceTable& table) : table_(&table), vector_table_(table.view()) {}
    [[nodiscard]] Vector operator()(std::size_t, Vector luminances) const { return vector_table_(luminances); }
    [[nodiscard]] float operator()(std::size_t, float luminance) const { return (*table_)(luminance); }

  private:
    const LuminanceTable* table_;
    VectorTable vector_table_;
};

class ByAdaptation {
  public:
    ByAdaptation(const LuminanceTable& table, const float* adaptation)
        : table_(&table), vector_table_(table.view()), adaptation_(adaptation) {}
    [[nodiscard]] Vector operator()(std::size_t x, Vector) const {
        return vector_table_(hn::LoadU(Floats(), adaptation_ + x));
    }
    [[nodiscard]] float operator()(std::size_t x, float) const { return (*table_)(adaptation_[x]); }

  private:
    const LuminanceTable* table_;
    VectorTable vector_table_;
    const float* adaptation_;
};

class ByBoth {
  public:
    ByBoth(const LuminanceTable& exposures, const LuminanceTable& compressions, const float* adaptation)
        : exposures_(exposures, adaptation), compressions_(compressions) {}
    [[nodiscard]] Vector operator()(std::size_t x, Vector luminances) const {
        const auto exposure = exposures_(x, luminances);
        return hn::Mul(exposure, compressions_(x, hn::Mul(exposure, luminances)));
    }
    [[nodiscard]] float operator()(std::size_t x, float luminance) const {
        const float exposure = exposures_(x, luminance);
        return exposure * compressions_(x, exposure * luminance);
    }

  private:
    ByAdaptation exposures_;
    ByLuminance compressions_;
};

void by_constant(float scale, std::span<const XYZ> in, std::span<XYZ> out, RowPixels pixels, LeftPixels& left) {
    scale_all(in, out, ByConstant(scale), pixels, left);
}

void by_luminance(const LuminanceTable& table, std::span<const XYZ> in, std::span<XYZ> out, RowPixels pixels,
                  LeftPixels& left) {
    scale_all(in, out, ByLuminance(table), pixels, left);
}

void by_adaptation(const LuminanceTable& table, std::span<const float> adaptation, std::span<const XYZ> in,
                   std::span<XYZ> out, RowPixels pixels, LeftPixels& left) {
    scale_all(in, out, ByAdaptation(table, adaptation.data()), pixels, left);
}

void by_both(const LuminanceTable& exposures, const LuminanceTable& compressions, std::span<const float> adaptation,
             std::span<const XYZ> in, std::span<XYZ> out, RowPixels pixels, LeftPixels& left) {
    scale_all(in, out, ByBoth(exposures, compressions, adaptation.data()), pixels, left);
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

}  // namespace

void scale_row(float scale, std::span<const XYZ> in, std::span<XYZ> out, RowPixels pixels, LeftPixels& left) {
    HWY_DYNAMIC_DISPATCH(by_constant)(scale, in, out, pixels, left);
}

void scale_row(const LuminanceTable& table, std::span<const XYZ> in, std::span<XYZ> out, RowPixels pixels,
               LeftPixels& left) {
    HWY_DYNAMIC_DISPATCH(by_luminance)(table, in, out, pixels, left);
}

void scale_row(const LuminanceTable& table, std::span<const float> adaptation, std::span<const XYZ> in,
               std::span<XYZ> out, RowPixels pixels, LeftPixels& left) {
    HWY_DYNAMIC_DISPATCH(by_adaptation)(table, adaptation, in, out, pixels, left);
}

void scale_row(const LuminanceTable& exposures, const LuminanceTable& compressions, std::span<const float> adaptation,
               std::span<const XYZ> in, std::span<XYZ> out, RowPixels pixels, LeftPixels& left) {
    HWY_DYNAMIC_DISPATCH(by_both)(exposures, compressions, adaptation, in, out, pixels, left);
}

}  // namespace emulsion
#endif
