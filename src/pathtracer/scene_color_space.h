#pragma once
// The RGB spaces that scenes and their pictures may be in.

#include <cstddef>
#include <optional>

#include "spectrum/rgb_space.h"

namespace emulsion {

/// The RGB spaces that pbrt-v4 has. "dci-p3" has the white D65 there: Display P3.
enum class ColorSpace { srgb, rec2020, dci_p3, aces2065_1 };
inline constexpr std::size_t kColorSpaces = 4;

[[nodiscard]] const RgbSpace& rgb_space_of(ColorSpace space);

/// The space of these primaries and white, each coordinate within a thousandth of itself, as pbrt-v4 looks them up;
/// unset if it is none of them.
[[nodiscard]] std::optional<ColorSpace> color_space_with_primaries_of(const RgbSpace& space);

}  // namespace emulsion
