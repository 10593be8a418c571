#pragma once
// A picture as rows of components, whatever its channels: RGB has three, grey one.

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "core/color.h"
#include "core/image.h"
#include "display/code_value.h"

namespace emulsion {

/// Components that belong to someone else: of each pixel in turn, rows contiguous from the top.
template <class T>
struct ComponentRows {
    T* data;
    int width, height;  ///< in pixels, at least 1
    int channels;       ///< components of a pixel

    /// width * channels components.
    [[nodiscard]] std::span<T> row(int y) const noexcept {
        const auto size = static_cast<std::size_t>(width) * static_cast<std::size_t>(channels);
        return {data + static_cast<std::size_t>(y) * size, size};
    }

    /// Those from row y on; y below the height.
    [[nodiscard]] ComponentRows from(int y) const noexcept { return {row(y).data(), width, height - y, channels}; }
};

/// What the quantizers read and write.
using EncodedRows = ComponentRows<const float>;
using CodeRows = ComponentRows<std::uint16_t>;

/// The components of an RGB picture.
template <class Pixel>
[[nodiscard]] auto rgb_rows(ImageView<Pixel> picture) noexcept {
    using Component = std::remove_reference_t<decltype((picture.pixels().data()->r))>;
    static_assert(sizeof(Pixel) == 3 * sizeof(Component));
    return ComponentRows<Component>{&picture.pixels().data()->r, picture.width(), picture.height(), 3};
}

/// Those of a picture with one channel.
template <class Component>
[[nodiscard]] ComponentRows<Component> grey_rows(ImageView<Component> picture) noexcept {
    return {picture.pixels().data(), picture.width(), picture.height(), 1};
}

}  // namespace emulsion
