#pragma once
// Image<T>: width x height pixels, row by row from the top left; ImageView<T>: the same pixels, not owned.

#include <algorithm>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "core/pixel_memory.h"

namespace emulsion {

/// A rectangle of whole pixels, [x0, x1) x [y0, y1).
struct PixelBounds {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    [[nodiscard]] constexpr int width() const noexcept { return x1 - x0; }
    [[nodiscard]] constexpr int height() const noexcept { return y1 - y0; }
    [[nodiscard]] constexpr bool contains(int x, int y) const noexcept {
        return x >= x0 && x < x1 && y >= y0 && y < y1;
    }
    /// Whether `inside` has pixels, and all of them are here.
    [[nodiscard]] constexpr bool contains(const PixelBounds& inside) const noexcept {
        return x0 <= inside.x0 && inside.x0 < inside.x1 && inside.x1 <= x1 &&  //
               y0 <= inside.y0 && inside.y0 < inside.y1 && inside.y1 <= y1;
    }
    bool operator==(const PixelBounds&) const = default;
};

/// "[0, 4) x [0, 3)": x, then y.
[[nodiscard]] inline std::string to_string(const PixelBounds& bounds) {
    return "[" + std::to_string(bounds.x0) + ", " + std::to_string(bounds.x1) + ") x [" + std::to_string(bounds.y0) +
           ", " + std::to_string(bounds.y1) + ")";
}

/// Pixels that belong to someone else: contiguous rows without padding.
template <class T>
class ImageView {
  public:
    ImageView(T* data, int width, int height) noexcept : data_(data), width_(width), height_(height) {}

    /// Pixels that may be changed may also be only looked at.
    template <class Mutable, std::enable_if_t<std::is_same_v<const Mutable, T>, int> = 0>
    ImageView(const ImageView<Mutable>& other) noexcept  // NOLINT(google-explicit-constructor)
        : data_(other.pixels().data()), width_(other.width()), height_(other.height()) {}

    [[nodiscard]] int width() const noexcept { return width_; }
    [[nodiscard]] int height() const noexcept { return height_; }
    [[nodiscard]] T& operator()(int x, int y) const noexcept { return row(y)[static_cast<std::size_t>(x)]; }
    [[nodiscard]] std::span<T> row(int y) const noexcept {
        const auto width = static_cast<std::size_t>(width_);
        return {data_ + static_cast<std::size_t>(y) * width, width};
    }
    [[nodiscard]] std::span<T> pixels() const noexcept {
        return {data_, static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)};
    }

  private:
    T* data_;
    int width_, height_;
};

/// For an Image whose pixels have no values yet: all are to be written before one is read. Saves a pass over memory,
/// and lets the threads that write it be those that first touch it.
struct UnsetPixels {};

template <class T>
class Image {
    static_assert(std::is_trivially_copyable_v<T>, "pixels may be left without values");
    static_assert(!std::is_same_v<T, bool>, "std::vector<bool> has no pixels to point at; take std::uint8_t");

  public:
    Image() = default;

    /// All pixels value-initialised.
    /// \throws std::invalid_argument unless both sizes are at least 1.
    Image(int width, int height) : Image(width, height, UnsetPixels{}) { std::ranges::fill(pixels_, T{}); }

    /// \throws std::invalid_argument likewise.
    Image(int width, int height, UnsetPixels /*unset*/) : width_(width), height_(height) {
        if (width < 1 || height < 1) {
            throw std::invalid_argument("image size " + std::to_string(width) + "x" + std::to_string(height) +
                                        ": both must be at least 1");
        }
        pixels_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    }

    [[nodiscard]] int width() const noexcept { return width_; }
    [[nodiscard]] int height() const noexcept { return height_; }
    [[nodiscard]] T& operator()(int x, int y) noexcept { return pixels_[index(x, y)]; }
    [[nodiscard]] const T& operator()(int x, int y) const noexcept { return pixels_[index(x, y)]; }
    [[nodiscard]] std::span<T> row(int y) & noexcept {
        return {&pixels_[index(0, y)], static_cast<std::size_t>(width_)};
    }
    [[nodiscard]] std::span<const T> row(int y) const& noexcept {
        return {&pixels_[index(0, y)], static_cast<std::size_t>(width_)};
    }
    [[nodiscard]] std::span<T> pixels() & noexcept { return pixels_; }
    [[nodiscard]] std::span<const T> pixels() const& noexcept { return pixels_; }
    /// Not of a temporary: a range-for over it would read freed pixels.
    void pixels() const&& = delete;
    void row(int y) const&& = delete;
    [[nodiscard]] ImageView<T> view() noexcept { return {pixels_.data(), width_, height_}; }
    [[nodiscard]] ImageView<const T> view() const noexcept { return {pixels_.data(), width_, height_}; }
    bool operator==(const Image&) const = default;

  private:
    [[nodiscard]] std::size_t index(int x, int y) const noexcept {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }

    int width_ = 0, height_ = 0;
    std::vector<T, PixelAllocator<T>> pixels_;
};

}  // namespace emulsion
