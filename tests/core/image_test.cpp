#include "core/image.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <limits>
#include <new>
#include <stdexcept>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>

namespace emulsion {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Image, IsValueInitialised) {
    const Image<float> image(3, 2);
    EXPECT_EQ(image.width(), 3);
    EXPECT_EQ(image.height(), 2);
    EXPECT_EQ(image.pixels().size(), 6u);
    EXPECT_THAT(image.pixels(), Each(0.0f));
}

TEST(Image, KeepsPixelsRowByRowFromTheTop) {
    Image<int> image(3, 2);
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 3; ++x) image(x, y) = 10 * y + x;
    }
    EXPECT_THAT(image.pixels(), ElementsAre(0, 1, 2, 10, 11, 12));
    EXPECT_THAT(image.row(1), ElementsAre(10, 11, 12));
    EXPECT_THAT(std::as_const(image).row(0), ElementsAre(0, 1, 2));
}

TEST(Image, DefaultHasNoPixels) {
    const Image<float> image;
    EXPECT_EQ(image.width(), 0);
    EXPECT_EQ(image.height(), 0);
    EXPECT_TRUE(image.pixels().empty());
    EXPECT_TRUE(image.view().pixels().empty());
}

TEST(Image, RefusesSizesBelowOne) {
    constexpr int kLowest = std::numeric_limits<int>::min();
    for (const auto& [width, height] : {std::pair{0, 1}, {1, 0}, {-1, 5}, {5, -1}, {0, 0}, {kLowest, kLowest}}) {
        EXPECT_THROW(Image<float>(width, height), std::invalid_argument) << width << "x" << height;
    }
    EXPECT_THAT([] { Image<float>(-3, 7); }, ThrowsMessage<std::invalid_argument>(HasSubstr("-3x7")));
}

TEST(Image, SizeBeyondMemoryThrows) {
    constexpr int kLargest = std::numeric_limits<int>::max();
    EXPECT_THROW(Image<double>(kLargest, kLargest), std::exception);
}

TEST(Image, CopiesAreIndependentAndCompareByPixels) {
    Image<int> a(2, 2);
    Image<int> b = a;
    EXPECT_EQ(a, b);
    b(1, 1) = 5;
    EXPECT_NE(a, b);
    EXPECT_EQ(a(1, 1), 0);
    EXPECT_NE(Image<int>(4, 1), Image<int>(1, 4)) << "same pixels, other shape";
}

TEST(ImageView, WritesThroughToTheImage) {
    Image<int> image(2, 3);
    const ImageView<int> view = image.view();
    view(1, 2) = 9;
    view.row(0)[1] = 4;
    EXPECT_EQ(image(1, 2), 9);
    EXPECT_EQ(image(1, 0), 4);
    EXPECT_EQ(view.pixels().data(), image.pixels().data());
    EXPECT_EQ(view.pixels().size(), 6u);
}

TEST(ImageView, IndicesBeyondAnIntAreRight) {
    // 2^16 columns by 2^15 + 1 rows of one byte, of which only the last page is ever touched.
    constexpr int kWidth = 1 << 16, kHeight = (1 << 15) + 1;
    constexpr std::size_t kSize = std::size_t{kWidth} * kHeight;
    void* const memory =
        ::mmap(nullptr, kSize, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    ASSERT_NE(memory, MAP_FAILED);
    const ImageView<std::uint8_t> view(static_cast<std::uint8_t*>(memory), kWidth, kHeight);
    view(kWidth - 1, kHeight - 1) = 7;
    EXPECT_EQ(view.pixels().size(), kSize);
    EXPECT_EQ(view.pixels().back(), 7);
    EXPECT_EQ(view.row(kHeight - 1).back(), 7);
    ::munmap(memory, kSize);
}

TEST(Image, HasPixelsWithValuesUnlessItIsToldNotTo) {
    for (int repeat = 0; repeat < 3; ++repeat) {  // memory that was used before
        Image<int> image(300, 200);
        for (const int p : image.pixels()) ASSERT_EQ(p, 0);
        for (int& p : image.pixels()) p = 7;
        Image<int> unset(300, 200, UnsetPixels{});
        for (int& p : unset.pixels()) p = 7;
        EXPECT_EQ(unset, image);
    }
    EXPECT_THROW((void)Image<int>(0, 5, UnsetPixels{}), std::invalid_argument);
}

TEST(PixelMemory, IsAlignedAndFreed) {
    constexpr std::size_t kHuge = std::size_t{1} << 21;
    for (const std::size_t bytes : {std::size_t{0}, std::size_t{1}, std::size_t{100}, 2 * kHuge - 1, 5 * kHuge + 3}) {
        void* const pixels = allocate_pixels(bytes);
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(pixels) % (bytes < 2 * kHuge ? 64 : kHuge), 0u) << bytes;
        if (bytes > 0) std::memset(pixels, 1, bytes);
        free_pixels(pixels);
    }
    EXPECT_THROW((void)allocate_pixels(std::numeric_limits<std::size_t>::max() - 5), std::bad_alloc);
    EXPECT_THROW((void)PixelAllocator<double>().allocate(std::numeric_limits<std::size_t>::max() / 4), std::bad_alloc);
}

TEST(PixelBounds, MeasuresItself) {
    constexpr PixelBounds kBounds{-2, 1, 5, 4};
    EXPECT_EQ(kBounds.width(), 7);
    EXPECT_EQ(kBounds.height(), 3);
}

}  // namespace
}  // namespace emulsion
