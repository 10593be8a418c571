// The loop over rows of any length, for inner loops that are compiled for several instruction sets: included once for
// each of them, after Highway.

// Highway's idiom in the place of `#pragma once`.
#if defined(EMULSION_CORE_VECTOR_LOOP_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EMULSION_CORE_VECTOR_LOOP_H
#undef EMULSION_CORE_VECTOR_LOOP_H
#else
#define EMULSION_CORE_VECTOR_LOOP_H
#endif

#include <cstddef>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace emulsion::HWY_NAMESPACE {

using Floats = hwy::HWY_NAMESPACE::ScalableTag<float>;
using OneFloat = hwy::HWY_NAMESPACE::CappedTag<float, 1>;

/// Calls step(tag, i) for vectors of [0, count), and for what is left over value by value: the same operations, so that
/// a value has the same bits in either.
template <class Step>
HWY_INLINE void for_each_vector(std::size_t count, const Step& step) {
    const std::size_t lanes = hwy::HWY_NAMESPACE::Lanes(Floats());
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) step(Floats(), i);
    for (; i < count; ++i) step(OneFloat(), i);
}

/// The same for pixels of three components, by up to eight: to sort the components of more takes more than it saves.
template <class Step>
HWY_INLINE void for_each_pixel_vector(std::size_t count, const Step& step) {
    const hwy::HWY_NAMESPACE::CappedTag<float, 8> tag;
    const std::size_t lanes = hwy::HWY_NAMESPACE::Lanes(tag);
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) step(tag, i);
    for (; i < count; ++i) step(OneFloat(), i);
}

}  // namespace emulsion::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
