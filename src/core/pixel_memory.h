#pragma once
// Memory for pictures.

#include <cstddef>
#include <limits>
#include <memory>
#include <new>
#include <utility>

namespace emulsion {

/// Memory for `bytes`, aligned to a cache line at least; where the system has pages of 2 MiB, large blocks lie in
/// those: first touching 200 MB in pages of 4 KiB takes longer than copying them. \throws std::bad_alloc
[[nodiscard]] void* allocate_pixels(std::size_t bytes);
void free_pixels(void* pixels) noexcept;

/// For a std::vector of pixels: from there, and left as it is unless it is given values.
template <class T>
struct PixelAllocator {
    using value_type = T;  // NOLINT(readability-identifier-naming): as the standard has it

    PixelAllocator() = default;
    template <class U>
    PixelAllocator(const PixelAllocator<U>& /*other*/) noexcept {}  // NOLINT(google-explicit-constructor)

    [[nodiscard]] T* allocate(std::size_t count) {
        if (count > std::numeric_limits<std::size_t>::max() / sizeof(T)) throw std::bad_alloc();
        return static_cast<T*>(allocate_pixels(count * sizeof(T)));
    }
    void deallocate(T* pixels, std::size_t /*count*/) noexcept { free_pixels(pixels); }

    template <class U, class... Values>
    void construct(U* place, Values&&... values) {
        if constexpr (sizeof...(Values) > 0) std::construct_at(place, std::forward<Values>(values)...);
    }
    template <class U>
    bool operator==(const PixelAllocator<U>& /*other*/) const noexcept {
        return true;
    }
};

}  // namespace emulsion
