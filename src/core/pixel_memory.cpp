#include "core/pixel_memory.h"

#include <algorithm>
#include <cstdlib>

#include <sys/mman.h>

namespace emulsion {

namespace {

constexpr std::size_t kCacheLine = 64;
constexpr std::size_t kHugePage = std::size_t{1} << 21;

}  // namespace

void* allocate_pixels(std::size_t bytes) {
    const std::size_t alignment = bytes >= 2 * kHugePage ? kHugePage : kCacheLine;
    if (bytes > std::numeric_limits<std::size_t>::max() - alignment) throw std::bad_alloc();
    const std::size_t whole = (std::max(bytes, std::size_t{1}) + alignment - 1) / alignment * alignment;
    void* const pixels = std::aligned_alloc(alignment, whole);
    if (pixels == nullptr) throw std::bad_alloc();
    if (alignment == kHugePage) (void)madvise(pixels, whole, MADV_HUGEPAGE);  // advice: it works without
    return pixels;
}

// NOLINTNEXTLINE(cppcoreguidelines-no-malloc): what std::aligned_alloc gives is to be freed so
void free_pixels(void* pixels) noexcept { std::free(pixels); }

}  // namespace emulsion
