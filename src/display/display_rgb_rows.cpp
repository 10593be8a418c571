#include "display/display_rgb_rows.h"

#include <cstddef>

// Compiled once for each instruction set; which of them runs is decided when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "display/display_rgb_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/vector_loop.h"

HWY_BEFORE_NAMESPACE();
namespace emulsion::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void multiply(const std::array<float, 9>& matrix, float pedestal, std::span<const XYZ> xyz, std::span<RGB> rgb) {
    static_assert(sizeof(XYZ) == 3 * sizeof(float) && sizeof(RGB) == 3 * sizeof(float));
    if (xyz.empty()) return;
    const float* const in = &xyz.data()->x;
    float* const out = &rgb.data()->r;
    for_each_pixel_vector(xyz.size(), [&](auto tag, std::size_t i) {
        auto x = hn::Zero(tag), y = x, z = x;
        hn::LoadInterleaved3(tag, in + 3 * i, x, y, z);
        const auto component = [&](std::size_t row) {
            const auto factor = [&](std::size_t column) { return hn::Set(tag, matrix[3 * row + column]); };
            const auto sum = hn::Add(hn::Add(hn::Mul(factor(0), x), hn::Mul(factor(1), y)), hn::Mul(factor(2), z));
            return hn::Sub(sum, hn::Set(tag, pedestal));
        };
        hn::StoreInterleaved3(component(0), component(1), component(2), tag, out + 3 * i);
    });
}

}  // namespace emulsion::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace emulsion {

namespace {

HWY_EXPORT(multiply);

}  // namespace

void linear_rgb(const std::array<float, 9>& matrix, float pedestal, std::span<const XYZ> xyz,
                std::span<RGB> rgb) noexcept {
    HWY_DYNAMIC_DISPATCH(multiply)(matrix, pedestal, xyz, rgb);
}

}  // namespace emulsion
#endif
