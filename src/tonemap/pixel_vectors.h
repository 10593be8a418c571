// Pixels in vectors, as they lie in memory: x y z x y z ... in three vectors for as many pixels as one has lanes. As 3
// and the number of lanes have no common factor, each luminance has a place of its own within its vector, and one
// blend of the three holds them all.
// Compiled once for each instruction set: included by sources that hwy/foreach_target.h includes again.

#include <array>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#if defined(EMULSION_TONEMAP_PIXEL_VECTORS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EMULSION_TONEMAP_PIXEL_VECTORS_H
#undef EMULSION_TONEMAP_PIXEL_VECTORS_H
#else
#define EMULSION_TONEMAP_PIXEL_VECTORS_H
#endif

HWY_BEFORE_NAMESPACE();
namespace emulsion::HWY_NAMESPACE {

using Floats = hwy::HWY_NAMESPACE::ScalableTag<float>;
using Vector = hwy::HWY_NAMESPACE::Vec<Floats>;

/// 3 Lanes(Floats()) floats.
struct PixelVectors {
    Vector a, b, c;
    PixelVectors(Vector first, Vector second, Vector third) : a(first), b(second), c(third) {}
    explicit PixelVectors(const float* pixels)
        : a(hwy::HWY_NAMESPACE::LoadU(Floats(), pixels)),
          b(hwy::HWY_NAMESPACE::LoadU(Floats(), pixels + hwy::HWY_NAMESPACE::Lanes(Floats()))),
          c(hwy::HWY_NAMESPACE::LoadU(Floats(), pixels + 2 * hwy::HWY_NAMESPACE::Lanes(Floats()))) {}
};

/// Which lane is whose.
class PixelLanes {
  public:
    PixelLanes()
        : in_a_(luminances_of(0)),
          in_b_(luminances_of(1)),
          order_(indices([](std::size_t i, std::size_t lanes) { return (3 * i + 1) % lanes; })),
          repeat_a_(repeats(0)),
          repeat_b_(repeats(1)),
          repeat_c_(repeats(2)) {}

    /// Y of each pixel, in an order of their own.
    [[nodiscard]] Vector some_luminances(const PixelVectors& pixels) const {
        namespace hn = hwy::HWY_NAMESPACE;
        return hn::IfThenElse(in_a_, pixels.a, hn::IfThenElse(in_b_, pixels.b, pixels.c));
    }

    /// Y of each pixel, in order.
    [[nodiscard]] Vector luminances(const PixelVectors& pixels) const {
        return hwy::HWY_NAMESPACE::TableLookupLanes(some_luminances(pixels), order_);
    }

    /// Each value three times, once for each component of its pixel.
    [[nodiscard]] PixelVectors repeated(Vector values) const {
        namespace hn = hwy::HWY_NAMESPACE;
        return {hn::TableLookupLanes(values, repeat_a_), hn::TableLookupLanes(values, repeat_b_),
                hn::TableLookupLanes(values, repeat_c_)};
    }

  private:
    using Mask = hwy::HWY_NAMESPACE::Mask<Floats>;
    using Indices = decltype(hwy::HWY_NAMESPACE::SetTableIndices(Floats(), static_cast<const std::int32_t*>(nullptr)));
    static constexpr std::size_t kMost = hwy::HWY_NAMESPACE::MaxLanes(Floats());

    /// Where vector number `which` of the three has luminances.
    static Mask luminances_of(std::size_t which) {
        namespace hn = hwy::HWY_NAMESPACE;
        const std::size_t lanes = hn::Lanes(Floats());
        std::array<float, kMost> is_luminance{};
        for (std::size_t i = 0; i < lanes; ++i) is_luminance[i] = (which * lanes + i) % 3 == 1 ? 1.0f : 0.0f;
        return hn::Ne(hn::LoadU(Floats(), is_luminance.data()), hn::Zero(Floats()));
    }
    template <class IndexOf>
    static Indices indices(const IndexOf& index_of) {
        namespace hn = hwy::HWY_NAMESPACE;
        const std::size_t lanes = hn::Lanes(Floats());
        std::array<std::int32_t, kMost> indices{};
        for (std::size_t i = 0; i < lanes; ++i) indices[i] = static_cast<std::int32_t>(index_of(i, lanes));
        return hn::SetTableIndices(Floats(), indices.data());
    }
    static Indices repeats(std::size_t which) {
        return indices([=](std::size_t i, std::size_t lanes) { return (which * lanes + i) / 3; });
    }

    Mask in_a_, in_b_;
    Indices order_, repeat_a_, repeat_b_, repeat_c_;
};

}  // namespace emulsion::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
